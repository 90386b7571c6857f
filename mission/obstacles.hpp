#pragma once
// The obstacles of a scenario: its own entries, and those of a file.

#include "mission/schema.hpp"

namespace furrow::mission {

/// Reads `obstacles` and `obstacles_file` into the field and the surprises of the scenario. Where
/// the file is on the globe, the scenario's datum is read before.
void read_obstacles(const Section& root, Draft& draft);

}  // namespace furrow::mission
