#pragma once

#include "app/results/flown.hpp"
#include "app/results/mission_record.hpp"
#include "app/results/report/shares.hpp"
#include "app/results/report/svg.hpp"

#include <string>
#include <vector>

namespace furrow::app {

/// The first sortie of each aircraft, of six at most, from the side: the ground, the clearance over
/// it and the height flown, with the least height above the ground in words. Empty over level land
/// and where nothing was flown.
std::string height_charts(const MissionRecord& record, const Flown& flown, const Colours& colours);

/// Lines of equal height of a surface within a rectangle, each piece two places, and the height
/// between neighbouring lines [m], 0 where the ground is level.
struct Contours {
  double step_m;
  std::vector<std::vector<FieldPoint>> pieces;
};
Contours contours(const planner::Surface& surface, const Extent& extent);

}  // namespace furrow::app
