#include "planner/returns/unplanned.hpp"

#include "planner/returns/evaluate.hpp"
#include "planner/returns/furthest.hpp"
#include "planner/returns/limits.hpp"

#include <fmt/format.h>

namespace furrow::planner {
namespace {

Returns returns_when_empty(const ReturnProblem& problem) {
  Returns returns;
  const auto last = static_cast<std::uint32_t>(problem.spray_m.size() - 1);
  for (std::uint32_t at = 0; (at = furthest_from(problem, at)) < last;) returns.push_back(at);
  return returns;
}

Expected<Returns, PlanError> returns_by_straight_moves(const ReturnProblem& problem) {
  const Limits limits = limits_of(problem);
  const double cell_m = problem.vehicle.swath.base();
  const auto tank_moves = static_cast<std::uint32_t>(limits.tank_m / cell_m);
  if (tank_moves < 2) {
    return Unexpected{PlanError{PlanFault::tank_too_small,
                                fmt::format("UAV {}: a tank lasts for {} straight moves",
                                            number(problem.vehicle.id), tank_moves)}};
  }
  Returns returns;
  std::size_t next_strip = 1;
  std::uint32_t moves = 0, allowed = tank_moves;
  for (std::uint32_t i = 1; i < problem.spray_m.size(); ++i) {
    if (next_strip < problem.strip_starts.size() && problem.strip_starts[next_strip] == i) {
      ++next_strip;
      continue;
    }
    if (moves == allowed) {
      returns.push_back(i - 1);
      moves = 0;
      allowed = tank_moves - 1;
    }
    ++moves;
  }
  return returns;
}

}  // namespace

Expected<ReturnPlan, PlanError> unplanned_plan(const ReturnProblem& problem, Counting counting) {
  if (counting == Counting::straight_moves) {
    const auto returns = returns_by_straight_moves(problem);
    if (!returns) return Unexpected{returns.error()};
    return evaluated(problem, *returns);
  }
  if (const auto error = infeasibility(problem)) return Unexpected{*error};
  return evaluated(problem, returns_when_empty(problem));
}

}  // namespace furrow::planner
