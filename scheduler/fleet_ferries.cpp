#include "scheduler/fleet_ferries.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace furrow::scheduler {
namespace {

using planner::PlanError;
using planner::PlanFault;

FieldPoint axis_of(const planner::KeepOut& volume) { return at_m(volume.x_m, volume.y_m); }

bool is_over(const planner::KeepOut& volume, const Ring& boundary) {
  const FieldPoint axis = axis_of(volume);
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

PlanError kept_out(const planner::KeepOut& volume, const std::string& how) {
  const FieldPoint axis = axis_of(volume);
  return {PlanFault::kept_out,
          fmt::format("the keep-out volume at ({:.3f}, {:.3f}) m {}", axis.x.base(), axis.y.base(),
                      how),
          axis};
}

// As an obstacle in plan.
Obstacle obstacle(const planner::KeepOut& volume, const planner::FerryRule& rule) {
  return {.id = "keep-out",
          .center = axis_of(volume),
          .radius = metres(volume.radius_m) + std::max(Length{}, rule.corner_cut - rule.safety)};
}

std::optional<PlanError> keep_out_fault(const planner::KeepOut& volume,
                                        const planner::FerryRule& rule, const Ring& boundary,
                                        bool is_survey, const std::vector<FieldPoint>& stands) {
  if (!is_survey && is_over(volume, boundary)) return kept_out(volume, "reaches over the field");
  const Length kept = std::max(rule.safety, rule.margin + rule.hole_buffer);
  const Length radius = obstacle(volume, rule).radius;
  for (const FieldPoint stand : stands) {
    const Length away = distance(stand, axis_of(volume)) - radius;
    if (away >= kept) continue;
    const auto place =
        fmt::format("({:.3f}, {:.3f}) m, where aircraft stand", stand.x.base(), stand.y.base());
    return kept_out(volume, away <= Length{}
                                ? "reaches over " + place
                                : fmt::format("is {:.3f} m from {}; ferries keep {:.3f} m",
                                              away.base(), place, kept.base()));
  }
  return std::nullopt;
}

// A way point of a survey that is in the volume, or nearer to it than ways are searched.
std::optional<PlanError> way_point_fault(const planner::KeepOut& volume, Length apart,
                                         const planner::Relief& relief,
                                         const std::vector<FieldPoint>& way_points) {
  for (const FieldPoint at : way_points) {
    const double flown_m = relief.work_altitude_m(at);
    if (flown_m < volume.bottom_m || flown_m > volume.top_m) continue;
    const Length away = distance(at, axis_of(volume)) - metres(volume.radius_m);
    if (away >= apart) continue;
    const auto place = fmt::format("the way point ({:.3f}, {:.3f}) m", at.x.base(), at.y.base());
    return kept_out(volume, away <= Length{}
                                ? "reaches over " + place
                                : fmt::format("is {:.3f} m from {}; surveys keep {:.3f} m",
                                              away.base(), place, apart.base()));
  }
  return std::nullopt;
}

std::optional<PlanError> low_ceiling(const planner::Relief& relief) {
  const auto ceiling = relief.rule().ceiling;
  if (!ceiling || relief.highest_ferry_m() <= ceiling->base()) return std::nullopt;
  return PlanError{PlanFault::ceiling_too_low,
                   fmt::format("ferries need {:.1f} m over the highest ground, the ceiling is "
                               "{:.1f} m",
                               relief.highest_ferry_m(), ceiling->base())};
}

}  // namespace

Expected<planner::FerryMap, PlanError> ferry_map(const FleetProblem& problem) {
  Field field = problem.field;
  planner::FerryRule rule{.corner_cut = corner_cut(problem)};
  std::visit([&](const auto& settings) { rule.margin = settings.margin; }, problem.coverage);
  if (const auto* swath = std::get_if<planner::SwathSettings>(&problem.coverage)) {
    rule.hole_buffer = swath->hole_buffer;
  }
  rule.safety = safety_of(problem);
  std::vector<FieldPoint> stands;
  const auto add = [&](FieldPoint at) {
    if (std::find(stands.begin(), stands.end(), at) == stands.end()) stands.push_back(at);
  };
  for (const Station& station : problem.stations) add(station.position);
  for (const Vehicle& vehicle : whole_fleet(problem)) add(vehicle.home);
  if (!problem.terrain) return planner::FerryMap::over(field, rule, stands);
  const planner::Relief relief{*problem.terrain, flown_over(field, stands)};
  for (const std::size_t i : relief.in_the_way()) {
    const planner::KeepOut& volume = relief.keep_out()[i];
    auto fault = keep_out_fault(volume, rule, field.boundary, problem.survey.has_value(), stands);
    if (!fault && problem.survey) {
      fault = way_point_fault(volume, rule.corner_cut, relief, problem.survey->way_points);
    }
    if (fault) return Unexpected{std::move(*fault)};
    field.obstacles.push_back(obstacle(volume, rule));
  }
  // Ferries that are searched lead around what is too high; those of the plan are judged by it.
  if (!problem.terrain->ferries) {
    if (auto fault = low_ceiling(relief)) return Unexpected{std::move(*fault)};
  }
  auto map = planner::FerryMap::over(field, rule, stands);
  if (!map) return map;
  return map->over_ground(relief, problem.terrain->ferries);
}

}  // namespace furrow::scheduler
