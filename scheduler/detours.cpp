#include "scheduler/detours.hpp"

#include <algorithm>

namespace furrow::scheduler {
namespace {

planner::PointM plane(FieldPoint p) { return {p.x.base(), p.y.base()}; }

// The cell of the strip that is nearest to a place.
std::uint32_t cell_at(const planner::Route& route, const planner::Strip& strip, FieldPoint place) {
  const auto first = route.centers.begin() + strip.cells.first;
  const auto nearest = std::min_element(
      first, first + strip.cells.count,
      [&](FieldPoint a, FieldPoint b) { return distance(a, place) < distance(b, place); });
  return static_cast<std::uint32_t>(nearest - route.centers.begin());
}

}  // namespace

std::vector<planner::MetDetour> detours(const planner::Route& route, const planner::Room& room,
                                        Length turn_radius, planner::DetourWeights weights) {
  std::vector<planner::MetDetour> by_cell(route.centers.size());
  bool is_any = false;
  if (planner::is_survey(route)) return {};
  for (const planner::Strip& strip : route.strips) {
    if (room.circles_near(plane(strip.begin), plane(strip.end), 0.0).empty()) continue;
    const auto way =
        planner::onboard_way(strip.begin, strip.end, route.cell, room, turn_radius, weights);
    if (!way || way->bends.empty()) continue;
    by_cell[cell_at(route, strip, way->bends.front().at)] = {
        .longer_m = way->longer.base(), .sprayed_m = (way->longer - way->dry).base()};
    is_any = true;
  }
  return is_any ? by_cell : std::vector<planner::MetDetour>{};
}

}  // namespace furrow::scheduler
