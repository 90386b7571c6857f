#include "scheduler/sketch.hpp"

#include "planner/at_once.hpp"
#include "planner/survey/rounds.hpp"
#include "scheduler/fleet_ferries.hpp"

#include <fmt/format.h>
#include <string>
#include <variant>

namespace furrow::scheduler {
namespace {

using planner::PlanError;
using planner::PlanFault;

std::optional<PlanError> cut_off_strip(const planner::Route& route,
                                       const planner::FerryMap& ferries) {
  for (const planner::Strip& strip : route.strips) {
    if (ferries.reaches(strip.begin) && ferries.reaches(strip.end)) continue;
    return PlanError{PlanFault::out_of_reach,
                     "the strip at (" + std::to_string(strip.begin.x.base()) + ", " +
                         std::to_string(strip.begin.y.base()) +
                         ") m is cut off from the stations by holes or obstacles",
                     strip.begin};
  }
  return std::nullopt;
}

// A walk knows cells, not what lies between two of them that it flies across; rows of one part of a
// field know no way to those of another.
void lead_around_holes(planner::Route& route, const std::vector<std::size_t>& leaps) {
  for (const std::size_t i : leaps) {
    route.strips[i].approach = approach_over(route.ferries, route.strips[i - 1], route.strips[i]);
  }
}

using Covered = Expected<planner::Coverage, PlanError>;
using Ferries = Expected<planner::FerryMap, PlanError>;

Expected<Sketch, PlanError> sketch(const FleetProblem& problem, const planner::FerryMap& ferries,
                                   Covered coverage) {
  if (!coverage) return Unexpected{coverage.error()};
  if (auto fault = cut_off_strip(coverage->route, ferries)) return Unexpected{std::move(*fault)};
  coverage->route.ferries = ferries;
  lead_around_holes(coverage->route, coverage->leaps);
  RouteLengths lengths = route_lengths(coverage->route, problem.stations);
  Draft drafted = draft(coverage->route, lengths, problem.vehicles, problem.stations);
  return Sketch{std::move(*coverage), std::move(lengths), std::move(drafted)};
}

/// The models to draft: one where the direction is given or the model searches it.
std::vector<planner::CoverageModel> candidates(const FleetProblem& problem) {
  const FieldPoint home = problem.vehicles.front().home;
  if (const auto* swath = std::get_if<planner::SwathSettings>(&problem.coverage)) {
    planner::SwathSettings settings = *swath;
    settings.direction_deg = problem.work_direction_deg;
    if (!settings.near) settings.near = home;
    return {settings};
  }
  planner::CoverageSettings settings = std::get<planner::CoverageSettings>(problem.coverage);
  if (!settings.start && !settings.near) settings.near = home;
  std::vector<planner::CoverageModel> models;
  for (const double direction_deg : {0.0, 90.0, 180.0, 270.0}) {
    settings.work_direction_deg = problem.work_direction_deg.value_or(direction_deg);
    models.emplace_back(settings);
    if (problem.work_direction_deg) break;
  }
  return models;
}

// Of the survey's way points.
std::optional<PlanError> too_near_to_obstacle(FieldPoint at, const FleetProblem& problem) {
  const Length kept = safety_of(problem);
  if (kept <= Length{}) return std::nullopt;
  for (const Obstacle& o : problem.field.obstacles) {
    if (-depth_in(o, at) >= kept) continue;
    return PlanError{PlanFault::out_of_reach,
                     fmt::format("the way point ({:.3f}, {:.3f}) m is nearer than {} m to obstacle "
                                 "{}",
                                 at.x.base(), at.y.base(), kept.base(), o.id),
                     at};
  }
  return std::nullopt;
}

/// The survey's way points in that order.
Sketch survey_along(const FleetProblem& problem, const planner::FerryMap& ferries,
                    std::span<const std::uint32_t> order) {
  planner::SurveyRule rule{.field = problem.field, .apart = corner_cut(problem), .speed = {}};
  for (const Vehicle& v : whole_fleet(problem)) {
    rule.speed = std::max(rule.speed, v.ferry_speed);
    rule.turn_radius = std::max(rule.turn_radius, v.min_turn_radius);
  }
  Sketch made{.coverage = {.route = planner::survey_route(*problem.survey, rule, ferries, order),
                           .direction_deg = 0,
                           .leaps = {},
                           .sweep = {}},
              .lengths = {},
              .draft = {}};
  made.lengths = route_lengths(made.coverage.route, problem.stations);
  made.draft = draft(made.coverage.route, made.lengths, problem.vehicles, problem.stations);
  return made;
}

/// The way points round after round of the aircraft, the last visited as early as can be.
std::vector<std::uint32_t> order_of_rounds(const FleetProblem& problem,
                                           const planner::FerryMap& ferries,
                                           std::span<const std::uint32_t> tour) {
  const std::vector<FieldPoint>& places = problem.survey->way_points;
  planner::VisitProblem visits{.places = static_cast<std::uint32_t>(places.size()),
                               .between_m = {},
                               .back_m = std::vector(places.size(), 0.0),
                               .visitors = {}};
  for (const FieldPoint from : places) {
    for (const FieldPoint to : places) visits.between_m.push_back(ferries.length(from, to).base());
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    Length nearest = ferries.length(places[i], problem.stations.front().position);
    for (const Station& s : problem.stations) {
      nearest = std::min(nearest, ferries.length(places[i], s.position));
    }
    visits.back_m[i] = nearest.base();
  }
  for (const Vehicle& v : problem.vehicles) {
    planner::VisitProblem::Visitor visitor{
        .out_m = {}, .mps = v.ferry_speed.base(), .ready_s = v.available_from.base()};
    for (const FieldPoint to : places) visitor.out_m.push_back(ferries.length(v.home, to).base());
    visits.visitors.push_back(std::move(visitor));
  }
  std::vector<std::uint32_t> order;
  for (const auto& round : planner::rounds(visits, tour)) {
    order.insert(order.end(), round.begin(), round.end());
  }
  return order;
}

Expected<Sketch, PlanError> survey_sketch(const FleetProblem& problem,
                                          const planner::FerryMap& ferries) {
  for (const FieldPoint at : problem.survey->way_points) {
    if (auto fault = too_near_to_obstacle(at, problem)) return Unexpected{std::move(*fault)};
    if (ferries.reaches(at)) continue;
    return Unexpected{PlanError{
        PlanFault::out_of_reach,
        fmt::format("the way point ({:.3f}, {:.3f}) m is cut off from the stations by holes, "
                    "obstacles or keep-out volumes",
                    at.x.base(), at.y.base()),
        at}};
  }
  const std::vector<std::uint32_t> tour =
      planner::survey_tour(*problem.survey, ferries, problem.vehicles.front().home);
  Sketch best = survey_along(problem, ferries, tour);
  if (problem.vehicles.size() == 1) return best;
  const std::vector<std::uint32_t> order = order_of_rounds(problem, ferries, tour);
  if (order == tour) return best;
  Sketch other = survey_along(problem, ferries, order);
  const bool is_better = worth(other.draft.forecast) < worth(best.draft.forecast);
  return is_better ? other : best;
}

}  // namespace

Expected<Sketch, PlanError> best_sketch(const FleetProblem& problem) {
  const auto models = problem.survey ? std::vector<planner::CoverageModel>{} : candidates(problem);
  // Ferries first, then what each model covers: none of these knows of another.
  auto made =
      planner::at_once(1 + models.size(), [&](std::size_t i) -> std::variant<Ferries, Covered> {
        if (i == 0) return ferry_map(problem);
        return planner::cover(problem.field, problem.vehicles.front().swath, models[i - 1]);
      });
  const Ferries& ferries = std::get<Ferries>(made.front());
  if (!ferries) return Unexpected{ferries.error()};
  if (problem.survey) return survey_sketch(problem, *ferries);
  auto best = sketch(problem, *ferries, std::get<Covered>(std::move(made[1])));
  for (std::size_t i = 2; i < made.size(); ++i) {
    auto other = sketch(problem, *ferries, std::get<Covered>(std::move(made[i])));
    if (!other) continue;
    const bool is_better =
        !best || other->draft.forecast.makespan_s < best->draft.forecast.makespan_s;
    if (is_better) best = std::move(other);
  }
  return best;
}

}  // namespace furrow::scheduler
