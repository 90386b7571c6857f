#include "planner/returns/objective.hpp"

#include "planner/returns/evaluate.hpp"

#include <algorithm>

namespace furrow::planner {

ReturnObjective::ReturnObjective(const ReturnProblem& problem, const ExtraCost& extra)
    : problem_{problem}, extra_{extra}, cost_{problem} {
  // What leaving out one return can save at most.
  const double furthest_m = *std::max_element(problem.home_m.begin(), problem.home_m.end());
  infeasible_s_ = 2.0 * furthest_m / problem.vehicle.ferry_speed.base() +
                  cost_.service_s(cost_.limits().tank_m, true);
}

double ReturnObjective::operator()(std::span<const std::uint32_t> returns) {
  ++evaluations_;
  const JudgedReturns judged = cost_(returns);
  if (judged.excess_s > 0.0) return judged.non_spray_s + judged.excess_s + infeasible_s_;
  if (!extra_) return judged.non_spray_s;
  return judged.non_spray_s + extra_(evaluated(problem_, {returns.begin(), returns.end()}));
}

}  // namespace furrow::planner
