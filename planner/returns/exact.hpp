#pragma once

#include "core/expected.hpp"
#include "planner/plan_error.hpp"
#include "planner/returns/problem.hpp"

#include <cstdint>

namespace furrow::planner {

struct ExactSettings {
  /// Steps after which the search ends with what it has: states of the bound and legs looked at,
  /// about 10^8 a second. A count and not a time, so that load changes no plan.
  std::uint64_t work_budget = 2'000'000'000;
};

struct ExactResult {
  ReturnPlan plan;       ///< The best found.
  double lower_bound_s;  ///< No plan has less non-spray time.
  bool proven;           ///< The plan attains the bound: it is an optimum.
  std::uint64_t work;    ///< Steps done.
};

/// The plan of least non-spray time, with its proof, or the best plan and bound within the budget.
///
/// Best-first search over partial plans, guided by a relaxation that knows the charge only to a
/// bucket. Buckets are narrowed, and cells that no better plan can return at are dropped, until the
/// search ends. Swaps are forced as in `evaluated`.
///
/// @error  tank_too_small, out_of_reach  See `infeasibility`.
///
/// Memory about 100 MB for 20 000 cells.
Expected<ExactResult, PlanError> exact_plan(const ReturnProblem& problem,
                                            const ExactSettings& settings = {});

/// Least non-spray time were packs inexhaustible: a bound that takes O(cells).
/// @pre `infeasibility(problem)` is empty.
double battery_free_bound_s(const ReturnProblem& problem);

}  // namespace furrow::planner
