#pragma once
// The terrain of a scenario file.

#include "mission/reader.hpp"
#include "mission/scenario.hpp"

namespace furrow::mission {

/// Reads `terrain`. Without peaks, base and file the land is level and heights are not flown.
/// @param scenario  Its field, datum, stations and aircraft have been read.
std::optional<planner::TerrainModel> read_terrain(const Section& terrain, const Scenario& scenario);

}  // namespace furrow::mission
