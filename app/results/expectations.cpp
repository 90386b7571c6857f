#include "app/results/expectations.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace furrow::app {
namespace {

std::string_view last_part(std::string_view path) { return path.substr(path.rfind('.') + 1); }

std::string required(const ExpectationFigures& e) {
  if (e.min && e.max && *e.min == *e.max) return fmt::format("{}", *e.min);
  if (e.min && e.max) return fmt::format("{} to {}", *e.min, *e.max);
  if (e.min) return fmt::format("at least {}", *e.min);
  if (e.max) return fmt::format("at most {}", *e.max);
  return "anything";
}

}  // namespace

std::vector<std::pair<std::string, double>> figures(const Result& r) {
  const double all_uavs = static_cast<double>(r.uavs.size());
  std::vector<std::pair<std::string, double>> all{
      {"completed", r.completed ? 1 : 0},
      {"partial", r.partial ? 1 : 0},
      {"field.area_m2", r.field.area_m2},
      {"field.strips", r.field.strips},
      {"field.strip_length_m", r.field.strip_length_m},
      {"field.cells", r.field.cells},
      {"coverage.covered_m2", r.coverage.covered_m2},
      {"coverage.missed_m2", r.coverage.missed_m2},
      {"coverage.repeated_m2", r.coverage.repeated_m2},
      {"coverage.outside_m2", r.coverage.outside_m2},
      {"coverage.unrouted_m2", r.coverage.unrouted_m2},
      {"coverage.abandoned_m2", r.coverage.abandoned_m2},
      {"coverage.uncertain_m2", r.coverage.uncertain_m2},
      {"footprint.wetted_m2", r.footprint.wetted_m2},
      {"footprint.footprint_missed_m2", r.footprint.missed_m2},
      {"footprint.footprint_overlap_m2", r.footprint.overlap_m2},
      {"footprint.footprint_outside_m2", r.footprint.outside_m2},
      {"fleet.makespan_s", r.fleet.makespan_s},
      {"fleet.planned_makespan_s", r.fleet.planned_makespan_s},
      {"fleet.lower_bound_s", r.fleet.lower_bound_s},
      {"fleet.spray_s", r.fleet.spray_s},
      {"fleet.non_spray_s", r.fleet.non_spray_s},
      {"fleet.queue_wait_s", r.fleet.queue_wait_s},
      {"fleet.route_m", r.fleet.route_m},
      {"fleet.ferry_m", r.fleet.ferry_m},
      {"fleet.flown_outside_m", r.fleet.flown_outside_m},
      {"fleet.outside_at_work_m", r.fleet.outside_at_work_m},
      {"fleet.rate_l_ha", r.fleet.rate_l_ha},
      {"fleet.sprayed_l", r.fleet.sprayed_l},
      {"fleet.repeated_l", r.fleet.repeated_l},
      {"fleet.outside_l", r.fleet.outside_l},
      {"fleet.uavs", all_uavs},
      {"solver.return_points", r.solver.return_points},
      {"solver.round_trips_m", r.solver.round_trips_m},
      {"solver.swaps", r.solver.swaps},
      {"solver.non_spray_s", r.solver.non_spray_s},
      {"solver.lower_bound_s", r.solver.lower_bound_s},
      {"solver.evaluations", static_cast<double>(r.solver.evaluations)},
      {"deviation.rms_m", r.deviation.truth.rms_m},
      {"deviation.max_m", r.deviation.truth.max_m},
      {"deviation.cross_track_rms_m", r.deviation.truth.rms_m},
      {"deviation.truth.rms_m", r.deviation.truth.rms_m},
      {"deviation.truth.max_m", r.deviation.truth.max_m},
      {"deviation.fix.rms_m", r.deviation.fix.rms_m},
      {"deviation.fix.max_m", r.deviation.fix.max_m},
      {"separation.encounters", r.separation.encounters},
      {"separation.near_s", r.separation.near_s},
      {"laws.violations", static_cast<double>(r.violations.size())},
      {"log.messages", static_cast<double>(r.log.messages)},
  };
  if (r.survey) {
    all.emplace_back("survey.way_points", r.survey->way_points);
    all.emplace_back("survey.visited", r.survey->visited);
    all.emplace_back("survey.uncertain", r.survey->uncertain);
  }
  if (r.fleet.gap) all.emplace_back("fleet.gap", *r.fleet.gap);
  if (r.solver.gap) all.emplace_back("solver.gap", *r.solver.gap);
  return all;
}

std::vector<ExpectationFigures> judged(const std::vector<mission::Expectation>& expectations,
                                       const Result& result) {
  const auto known = figures(result);
  std::vector<ExpectationFigures> verdicts;
  for (const mission::Expectation& e : expectations) {
    auto found = std::find_if(known.begin(), known.end(),
                              [&](const auto& figure) { return figure.first == e.key; });
    if (found == known.end()) {
      found = std::find_if(known.begin(), known.end(),
                           [&](const auto& figure) { return last_part(figure.first) == e.key; });
    }
    ExpectationFigures verdict{
        .key = e.key, .met = false, .value = {}, .min = e.min, .max = e.max, .message = {}};
    if (found == known.end()) {
      verdict.message = fmt::format("{}: the result has no such figure", e.key);
    } else {
      verdict.value = found->second;
      verdict.met = (!e.min || found->second >= *e.min) && (!e.max || found->second <= *e.max);
      if (!verdict.met) {
        verdict.message =
            fmt::format("{} is {}, expected {}", e.key, found->second, required(verdict));
      }
    }
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

bool all_met(const Result& result) {
  return std::all_of(result.expectations.begin(), result.expectations.end(),
                     [](const ExpectationFigures& e) { return e.met; });
}

}  // namespace furrow::app
