#pragma once

#include "app/results/flown.hpp"

#include <string>

namespace furrow::app {

/// plan.geojson: field, obstacles, stations, strips by UAV, return points and missed cells, as the
/// plan has them. Coordinates are metres east and north in the field's local frame, which the
/// member "frame" says; no datum is known.
std::string plan_geojson(const MissionRecord& record);

}  // namespace furrow::app
