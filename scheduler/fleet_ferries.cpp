#include "scheduler/fleet_ferries.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace furrow::scheduler {
namespace {

using planner::PlanError;
using planner::PlanFault;

bool is_over(const planner::KeepOut& volume, const Ring& boundary) {
  const FieldPoint axis = at_m(volume.x_m, volume.y_m);
  return contains(boundary, axis) || edge_distance(boundary, axis).base() < volume.radius_m;
}

// All that ferries may fly over: the field, and the stands with their aprons (see FerryMap).
Extent flown_over(const Field& field, const std::vector<FieldPoint>& stands) {
  constexpr double apron = 1.6;
  constexpr Length spare = metres(30);
  Extent all{field.boundary.front(), field.boundary.front()};
  for (const FieldPoint p : field.boundary) cover(all, p, spare);
  for (const FieldPoint stand : stands) {
    cover(all, stand, spare + apron * edge_distance(field.boundary, stand));
  }
  return all;
}

std::optional<PlanError> terrain_fault(const planner::Relief& relief, const Ring& boundary,
                                       bool is_survey, bool is_searched) {
  for (const planner::KeepOut& volume : relief.keep_out()) {
    if (is_survey || !is_over(volume, boundary)) continue;
    return PlanError{PlanFault::out_of_reach,
                     fmt::format("the keep-out volume at ({:.3f}, {:.3f}) m reaches over the field",
                                 volume.x_m, volume.y_m)};
  }
  const auto ceiling = relief.rule().ceiling;
  if (is_searched) return std::nullopt;  // ferries lead around what is too high, or see below
  if (ceiling && relief.highest_ferry_m() > ceiling->base()) {
    return PlanError{PlanFault::out_of_reach,
                     fmt::format("ferries need {:.1f} m over the highest ground, the ceiling is "
                                 "{:.1f} m",
                                 relief.highest_ferry_m(), ceiling->base())};
  }
  return std::nullopt;
}

}  // namespace

Expected<planner::FerryMap, PlanError> ferry_map(const FleetProblem& problem) {
  // Rounding at the corners around a circle must not keep strips' ends out of the ferries' land.
  constexpr double kept_safety = 0.96;
  Field field = problem.field;
  planner::FerryRule rule{.corner_cut = corner_cut(problem)};
  std::visit([&](const auto& settings) { rule.margin = settings.margin; }, problem.coverage);
  if (const auto* swath = std::get_if<planner::SwathSettings>(&problem.coverage)) {
    rule.hole_buffer = swath->hole_buffer;
  }
  rule.safety = kept_safety * safety_of(problem);
  std::vector<FieldPoint> stands;
  const auto add = [&](FieldPoint at) {
    if (std::find(stands.begin(), stands.end(), at) == stands.end()) stands.push_back(at);
  };
  for (const Station& station : problem.stations) add(station.position);
  for (const Vehicle& vehicle : whole_fleet(problem)) add(vehicle.home);
  if (!problem.terrain) return planner::FerryMap::over(field, rule, stands);
  const planner::Relief relief{*problem.terrain, flown_over(field, stands)};
  if (auto fault = terrain_fault(relief, field.boundary, problem.survey.has_value(),
                                 problem.terrain->ferries.has_value())) {
    return Unexpected{std::move(*fault)};
  }
  for (const planner::KeepOut& volume : relief.keep_out()) {
    field.obstacles.push_back(
        {.id = "keep-out",
         .center = at_m(volume.x_m, volume.y_m),
         .radius = metres(volume.radius_m) + std::max(Length{}, rule.corner_cut - rule.safety)});
  }
  auto map = planner::FerryMap::over(field, rule, stands);
  if (!map) return map;
  return map->over_ground(relief, problem.terrain->ferries);
}

}  // namespace furrow::scheduler
