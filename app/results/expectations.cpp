#include "app/results/expectations.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>
#include <string_view>

namespace furrow::app {
namespace {

struct Figure {
  std::string_view key;
  std::optional<double> value;
};

// What a scenario can expect.
std::array<Figure, 16> figures(const Result& r) {
  return {{{"completed", r.completed ? 1.0 : 0.0},
           {"covered_m2", r.coverage.covered_m2},
           {"missed_m2", r.coverage.missed_m2},
           {"repeated_m2", r.coverage.repeated_m2},
           {"outside_m2", r.coverage.outside_m2},
           {"makespan_s", r.fleet.makespan_s},
           {"gap", r.fleet.gap},
           {"non_spray_s", r.fleet.non_spray_s},
           {"queue_wait_s", r.fleet.queue_wait_s},
           {"route_m", r.fleet.route_m},
           {"ferry_m", r.fleet.ferry_m},
           {"flown_outside_m", r.fleet.flown_outside_m},
           {"outside_at_work_m", r.fleet.outside_at_work_m},
           {"cross_track_rms_m", r.deviation.truth.rms_m},
           {"encounters", r.separation.encounters},
           {"clearance_share",
            r.clearance ? std::optional{r.clearance->share} : std::optional<double>{}}}};
}

std::string required(const mission::Expectation& e) {
  if (e.min && e.max && *e.min == *e.max) return fmt::format("{}", *e.min);
  if (e.min && e.max) return fmt::format("{} to {}", *e.min, *e.max);
  if (e.min) return fmt::format("at least {}", *e.min);
  if (e.max) return fmt::format("at most {}", *e.max);
  return "anything";
}

ExpectationFigures judged(const mission::Expectation& e, std::optional<double> value) {
  ExpectationFigures verdict{
      .key = e.key, .met = false, .value = value, .min = e.min, .max = e.max, .message = {}};
  if (!value) {
    verdict.message = fmt::format("{}: this result has no such figure", e.key);
    return verdict;
  }
  verdict.met = (!e.min || *value >= *e.min) && (!e.max || *value <= *e.max);
  if (!verdict.met) {
    verdict.message = fmt::format("{} is {}, expected {}", e.key, *value, required(e));
  }
  return verdict;
}

}  // namespace

std::vector<ExpectationFigures> judged(const std::vector<mission::Expectation>& expectations,
                                       const Result& result) {
  const auto known = figures(result);
  std::vector<ExpectationFigures> verdicts;
  verdicts.reserve(expectations.size());
  for (const mission::Expectation& e : expectations) {
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const Figure& figure) { return figure.key == e.key; });
    verdicts.push_back(judged(e, found == known.end() ? std::nullopt : found->value));
  }
  return verdicts;
}

bool all_met(const Result& result) {
  return std::all_of(result.expectations.begin(), result.expectations.end(),
                     [](const ExpectationFigures& e) { return e.met; });
}

}  // namespace furrow::app
