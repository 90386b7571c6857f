#include "planner/returns/furthest.hpp"

#include "planner/returns/limits.hpp"

namespace furrow::planner {

bool carries(const ReturnProblem& problem, std::uint32_t first, std::uint32_t last) {
  const Limits limits = limits_of(problem);
  const double ferry_s = problem.hills ? problem.out_pack_s(first) + problem.back_pack_s(last)
                                       : (problem.out_m[first] + problem.back_m[last]) /
                                             problem.vehicle.ferry_speed.base();
  const double flight_s = ferry_s + problem.route_pack_s(last) - problem.resume_pack_s(first);
  return problem.spray_m[last] - problem.resume_m[first] <= limits.tank_m &&
         flight_s <= limits.pack_s;
}

std::uint32_t furthest_from(const ReturnProblem& problem, std::uint32_t first) {
  const Limits limits = limits_of(problem);
  std::uint32_t furthest = first;
  for (std::uint32_t i = first + 1; i < problem.spray_m.size(); ++i) {
    if (problem.spray_m[i] - problem.resume_m[first] > limits.tank_m) break;
    if (problem.on_route_s[i] - problem.resume_s[first] > limits.pack_s) break;
    if (carries(problem, first, i)) furthest = i;
  }
  return furthest;
}

}  // namespace furrow::planner
