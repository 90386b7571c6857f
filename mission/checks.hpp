#pragma once
// Rules across keys, for a draft whose keys are each in order.

#include "mission/schema.hpp"

namespace furrow::mission {

/// Adds an error for each rule broken between keys of different parts of the file, as far as those
/// parts are in order by themselves.
void check_together(const Section& root, const Draft& draft);

}  // namespace furrow::mission
