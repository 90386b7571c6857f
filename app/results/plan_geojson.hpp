#pragma once

#include "app/results/flown.hpp"

#include <string>

namespace furrow::app {

/// plan.geojson: field, obstacles, stations, strips by UAV or way points and the ways between them,
/// return points and missed cells, as the plan has them. Coordinates are metres east and north in
/// the field's local frame. The member "frame" says so, with the place of its origin on the globe
/// where that is known.
std::string plan_geojson(const MissionRecord& record);

}  // namespace furrow::app
