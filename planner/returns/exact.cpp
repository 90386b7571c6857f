#include "planner/returns/exact.hpp"

#include "planner/returns/battery_bound.hpp"
#include "planner/returns/evaluate.hpp"
#include "planner/returns/label_search.hpp"
#include "planner/returns/legs.hpp"
#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"

#include <algorithm>
#include <limits>

namespace furrow::planner {
namespace {

constexpr double proven_gap_s = 1e-6;
constexpr double first_buckets_per_pack = 64.0;
constexpr double narrowing = 4.0;
constexpr double narrowest_bucket_s = 1e-3;
constexpr double max_states = 8e6;  // of one bound: 64 MB

// The best plan so far and what is proven about it.
struct Progress {
  ReturnPlan plan;
  double lower_s;
  std::uint64_t work_left;

  void learn(const ReturnProblem& problem, const SearchOutcome& outcome) {
    if (outcome.better) plan = evaluated(problem, *outcome.better);
    lower_s = std::max(lower_s, std::min(outcome.lower_bound_s, plan.non_spray_s));
  }
  bool proven() const { return plan.non_spray_s - lower_s <= proven_gap_s; }
};

std::vector<std::uint32_t> first_candidates(const Legs& legs, const BatteryFree& free,
                                            double cutoff_s) {
  std::vector<std::uint32_t> cells;
  for (std::uint32_t i = 1; i <= legs.last; ++i) {
    if (free.until_s[i] + free.after_s[i] <= cutoff_s) cells.push_back(i);
  }
  return cells;
}

// The best feasible one.
ReturnPlan first_plan(const ReturnProblem& problem, std::initializer_list<ReturnPlan> plans) {
  const auto cost_s = [&](const ReturnPlan& plan) {
    return is_feasible(problem, plan) ? plan.non_spray_s : std::numeric_limits<double>::infinity();
  };
  return *std::min_element(plans.begin(), plans.end(),
                           [&](const auto& a, const auto& b) { return cost_s(a) < cost_s(b); });
}

// The widest buckets to start with that fit into memory.
double first_bucket_s(const Legs& legs, std::size_t candidates) {
  const double fitting = max_states / static_cast<double>(candidates);
  return legs.pack_s / std::min(first_buckets_per_pack, fitting);
}

// Sharpens the bound round by round until the search ends, or the work is used up.
void close_gap(const ReturnProblem& problem, const Legs& legs, const BatteryFree& free,
               Progress& progress) {
  constexpr double slack_s = 1e-6;  // bounds are sums in another order than the plan's cost
  std::vector<std::uint32_t> candidates =
      first_candidates(legs, free, progress.plan.non_spray_s + slack_s);
  double bucket_s = first_bucket_s(legs, candidates.size());
  while (!progress.proven() && progress.work_left > 0) {
    const std::uint64_t work_before = progress.work_left;
    const auto bound = BatteryBound::compute(
        legs, free, {bucket_s, std::move(candidates), progress.plan.non_spray_s + slack_s},
        progress.work_left);
    if (!bound) return;
    progress.learn(problem, dive(legs, *bound, progress.plan.non_spray_s, progress.work_left));

    // A search may take a quarter of the bound's work; beyond that a sharper bound is the better
    // deal, as long as one is to be had.
    candidates = bound->surviving(free, progress.plan.non_spray_s + slack_s);
    bucket_s /= narrowing;
    const double next_states = static_cast<double>(candidates.size()) * legs.pack_s / bucket_s;
    const bool last_round = next_states > max_states || bucket_s < narrowest_bucket_s;
    const std::uint64_t fair_share = (work_before - progress.work_left) / 4 + 100'000;
    const std::uint64_t allowance =
        last_round ? progress.work_left : std::min(progress.work_left, fair_share);
    std::uint64_t search_left = allowance;
    progress.learn(problem, best_first(legs, *bound, progress.plan.non_spray_s, search_left));
    progress.work_left -= allowance - search_left;
    if (last_round) return;
  }
}

}  // namespace

Expected<ExactResult, PlanError> exact_plan(const ReturnProblem& problem,
                                            const ExactSettings& settings) {
  const auto unplanned = unplanned_plan(problem);
  if (!unplanned) return Unexpected{unplanned.error()};
  const auto simple = simple_plan(problem);
  if (!simple) return Unexpected{simple.error()};

  const Legs legs = legs_of(problem);
  const BatteryFree free = battery_free(legs);
  Progress progress{
      .plan = first_plan(
          problem, {evaluated(problem, battery_free_returns(legs, free)), *unplanned, *simple}),
      .lower_s = free.optimum_s,
      .work_left = settings.work_budget};
  close_gap(problem, legs, free, progress);
  const bool proven = progress.proven();
  return ExactResult{.plan = progress.plan,
                     .lower_bound_s = proven ? progress.plan.non_spray_s : progress.lower_s,
                     .proven = proven,
                     .work = settings.work_budget - progress.work_left};
}

double battery_free_bound_s(const ReturnProblem& problem) {
  return battery_free(legs_of(problem)).optimum_s;
}

}  // namespace furrow::planner
