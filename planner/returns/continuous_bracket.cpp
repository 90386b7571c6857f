#include "planner/returns/continuous_bracket.hpp"

#include "planner/returns/legs.hpp"

#include <algorithm>
#include <vector>

namespace furrow::planner {
namespace {

double cell_m(const Legs& legs, std::uint32_t i) {
  return i == 0 ? legs.spray_m[0] : legs.spray_m[i] - legs.spray_m[i - 1];
}

// How near to the station a place within cell i may be. Entry 0 of the resumes is the beginning of
// the share, seen from the aircraft's first position.
double least_m(const ReturnProblem& problem, std::uint32_t i, double cell_m) {
  const double end_m = problem.back_m[i];
  if (cell_m <= 0.0) return end_m;
  const double least_m = i < 2 ? end_m - cell_m : 0.5 * (problem.out_m[i - 1] + end_m - cell_m);
  return std::max(0.0, least_m);
}

Legs relaxed(const ReturnProblem& problem) {
  const double ferry_mps = problem.vehicle.ferry_speed.base();
  Legs legs = legs_of(problem);
  double longest_m = 0.0;
  for (std::uint32_t i = 0; i <= legs.last; ++i) longest_m = std::max(longest_m, cell_m(legs, i));

  legs.tank_m += longest_m;
  legs.fill_base_s -= longest_m * legs.fill_s_per_m;
  std::uint32_t end = 0;
  std::vector<double> trips_s;
  for (std::uint32_t i = 0; i <= legs.last; ++i) {
    const double trip_s =
        std::min(2.0 * least_m(problem, i, cell_m(legs, i)) / ferry_mps, legs.trip_s(i));
    trips_s.push_back(trip_s);
    while (end < legs.last && legs.spray_m[end + 1] - problem.resume_m[i] <= legs.tank_m) ++end;
    legs.reach[i] = end;
  }
  for (std::uint32_t i = 0; i <= legs.last; ++i) {  // only their sum counts
    legs.back_s[i] = legs.leave_s[i] = 0.5 * trips_s[i];
  }
  return legs;
}

}  // namespace

Expected<ContinuousBracket, PlanError> continuous_bracket(const ReturnProblem& problem,
                                                          const ExactSettings& settings) {
  auto upper = exact_plan(problem, settings);
  if (!upper) return Unexpected{upper.error()};
  const double lower_s =
      std::min(battery_free(relaxed(problem)).optimum_s, upper->plan.non_spray_s);
  const double ferry_mps = problem.vehicle.ferry_speed.base();
  const double flown_s =
      problem.fly_out_m / ferry_mps + problem.on_route_s.back() + problem.back_m.back() / ferry_mps;
  const double upper_s = upper->plan.non_spray_s;
  return ContinuousBracket{.upper = std::move(*upper),
                           .lower_s = lower_s,
                           .mission_upper_s = flown_s + upper_s,
                           .mission_lower_s = flown_s + lower_s};
}

}  // namespace furrow::planner
