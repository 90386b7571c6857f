#pragma once

#include "core/expected.hpp"
#include "planner/plan_error.hpp"
#include "planner/returns/problem.hpp"

#include <cstdint>
#include <functional>

namespace furrow::planner {

/// How return points are chosen. `joint` is for fleets, whose shares, order and stations are then
/// chosen with them; one aircraft alone has them by GSA.
enum class ReturnStrategy { unplanned, simple, gsa, exact, joint };

/// Whether an aircraft's own return points are chosen by GSA.
constexpr bool is_by_gravity(ReturnStrategy s) {
  return s == ReturnStrategy::gsa || s == ReturnStrategy::joint;
}

/// The stable name used in scenario files and results.
constexpr const char* name(ReturnStrategy s) {
  switch (s) {
    case ReturnStrategy::unplanned: return "unplanned";
    case ReturnStrategy::simple: return "simple";
    case ReturnStrategy::gsa: return "gsa";
    case ReturnStrategy::exact: return "exact";
    case ReturnStrategy::joint: return "joint";
  }
  return "unknown";
}

struct SolveSettings {
  ReturnStrategy returns;
  bool refine;               ///< Local refinement after GSA.
  bool paper_counting;       ///< The paper's counting of straight moves; `unplanned` only.
  std::uint32_t iterations;  ///< Of GSA.
  std::uint32_t masses;      ///< Of GSA, its population.
  double budget_s;           ///< Turned into a fixed count of work, so that load changes no plan.
  std::uint64_t seed;
};

/// Seconds that a plan costs besides its non-spray time: waiting for a bay, mostly.
using ExtraCost = std::function<double(const ReturnPlan&)>;

/// A plan and what it is worth.
struct Solution {
  ReturnPlan plan;
  double objective_s;      ///< Non-spray time plus extra cost of `plan`.
  double gsa_objective_s;  ///< The same of the pure GSA result before refinement; GSA only, else 0.
  double lower_bound_s;    ///< No plan has less non-spray time (without extra cost).
  bool proven;             ///< The bound is attained: it is the optimum.
  std::uint64_t evaluations;
};

/// Chooses the return points by `settings.returns` and judges them against the proven optimum, or
/// against the best bound that the budget allows.
///
/// @param extra  Added to the objective by GSA and refinement; the other strategies ignore it.
///
/// @error  out_of_reach   Some cell cannot be reached, sprayed and left on one pack.
/// @error  tank_too_small One tank does not last for one cell.
Expected<Solution, PlanError> solve(const ReturnProblem& problem, const SolveSettings& settings,
                                    const ExtraCost& extra = {});

}  // namespace furrow::planner
