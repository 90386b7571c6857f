#include "planner/returns/objective.hpp"

#include "planner/returns/evaluate.hpp"

#include <algorithm>

namespace furrow::planner {

ReturnObjective::ReturnObjective(const ReturnProblem& problem, const ExtraCost& extra)
    : problem_{problem}, extra_{extra}, cost_{problem} {
  // What leaving out one return can save at most.
  double furthest_s = 0;
  for (std::uint32_t i = 0; i <= cost_.last_cell(); ++i) {
    furthest_s = std::max(furthest_s, problem.back_s(i));
  }
  infeasible_s_ = 2.0 * furthest_s + cost_.service_s(cost_.limits().tank_m, true);
}

double ReturnObjective::operator()(std::span<const std::uint32_t> returns) {
  ++evaluations_;
  const JudgedReturns judged = cost_(returns);
  if (judged.excess_s > 0.0) return judged.non_spray_s + judged.excess_s + infeasible_s_;
  if (!extra_) return judged.non_spray_s;
  return judged.non_spray_s + extra_(evaluated(problem_, {returns.begin(), returns.end()}));
}

}  // namespace furrow::planner
