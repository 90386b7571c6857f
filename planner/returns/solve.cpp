#include "planner/returns/solve.hpp"

#include "core/require.hpp"
#include "planner/returns/evaluate.hpp"
#include "planner/returns/exact.hpp"
#include "planner/returns/gsa_returns.hpp"
#include "planner/returns/objective.hpp"
#include "planner/returns/refine.hpp"
#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

// What counts as a second of budget. Set low, for a slow machine: the work is fixed, not the time.
constexpr double evaluations_per_s = 200'000.0;
constexpr double evaluations_with_extra_per_s = 50'000.0;
constexpr double exact_steps_per_s = 1e8;

// GSA needs little where a refinement follows, unless there is an extra cost, which the wider moves
// of the refinement do not see.
constexpr double gsa_share_before_refinement = 0.1;
constexpr double gsa_share_with_extra = 0.5;
constexpr std::size_t most_refined = 4;

std::uint64_t whole(double count) {
  return static_cast<std::uint64_t>(std::clamp(count, 0.0, 1e18));
}

// As many searches as the budget has room for; if not even one, a search of fewer iterations.
GsaReturnsSettings fitted(const SolveSettings& settings, std::uint64_t evaluations) {
  const std::uint64_t per_iteration = settings.masses;
  const std::uint64_t iterations =
      std::clamp<std::uint64_t>(evaluations / per_iteration, 2,
                                settings.iterations + std::uint64_t{1}) -
      1;
  const std::uint64_t searches = evaluations / (per_iteration * (iterations + 1));
  return {.masses = settings.masses,
          .iterations = static_cast<std::uint32_t>(iterations),
          .searches = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(searches, 1, 1'000'000)),
          .seed = settings.seed};
}

Solution by_gravity(const ReturnProblem& problem, const SolveSettings& settings,
                    const ExtraCost& extra) {
  ReturnObjective objective{problem, extra};
  const double evaluations =
      settings.budget_s * (extra ? evaluations_with_extra_per_s : evaluations_per_s);
  double share = 1.0;
  if (settings.refine) share = extra ? gsa_share_with_extra : gsa_share_before_refinement;

  const auto found = gsa_returns(problem, fitted(settings, whole(share * evaluations)), objective);
  FoundReturns best = found.front();
  if (settings.refine) {
    const std::size_t count = std::min(found.size(), most_refined);
    const double moves = (1.0 - share) * evaluations / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
      FoundReturns better = refined(problem, found[i].returns, objective, whole(moves));
      if (better.objective_s < best.objective_s) best = std::move(better);
    }
  }
  return {.plan = evaluated(problem, best.returns),
          .objective_s = best.objective_s,
          .gsa_objective_s = found.front().objective_s,
          .lower_bound_s = 0.0,
          .proven = false,
          .evaluations = objective.evaluations()};
}

Solution without_search(ReturnPlan plan, const ExtraCost& extra) {
  const double extra_s = extra ? extra(plan) : 0.0;
  const double objective_s = plan.non_spray_s + extra_s;
  return {.plan = std::move(plan),
          .objective_s = objective_s,
          .gsa_objective_s = 0.0,
          .lower_bound_s = 0.0,
          .proven = false,
          .evaluations = 1};
}

Expected<Solution, PlanError> chosen(const ReturnProblem& problem, const SolveSettings& settings,
                                     const ExtraCost& extra, const ExactResult& exact) {
  switch (settings.returns) {
    case ReturnStrategy::unplanned: {
      auto plan = unplanned_plan(
          problem, settings.paper_counting ? Counting::straight_moves : Counting::every_move);
      if (!plan) return Unexpected{plan.error()};
      return without_search(std::move(*plan), extra);
    }
    case ReturnStrategy::simple: {
      auto plan = simple_plan(problem);
      if (!plan) return Unexpected{plan.error()};
      return without_search(std::move(*plan), extra);
    }
    case ReturnStrategy::gsa:
    case ReturnStrategy::joint: return by_gravity(problem, settings, extra);
    case ReturnStrategy::exact: break;
  }
  return without_search(exact.plan, extra);
}

}  // namespace

Expected<Solution, PlanError> solve(const ReturnProblem& problem, const SolveSettings& settings,
                                    const ExtraCost& extra) {
  require(settings.masses > 0, "gravity needs a mass");
  const auto exact = exact_plan(problem, {.work_budget = std::max<std::uint64_t>(
                                              whole(settings.budget_s * exact_steps_per_s), 1)});
  if (!exact) return Unexpected{exact.error()};

  auto solution = chosen(problem, settings, extra, *exact);
  if (!solution) return solution;
  solution->lower_bound_s = exact->lower_bound_s;
  // Sums of the same costs in another order differ by far less than a nanosecond.
  solution->proven = !extra && is_feasible(problem, solution->plan) &&
                     solution->plan.non_spray_s <= exact->lower_bound_s + 1e-9;
  return solution;
}

}  // namespace furrow::planner
