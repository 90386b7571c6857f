// Return points by gravity on the 700 x 100 m field of Wang et al. 2017, over 30 seeds: how good,
// and in what time. Counters are minutes of non-spray time, beside the paper's own GSA and the
// optimum; `gap_worst` is the worst seed's share above the optimum.
#include "planner/returns/evaluate.hpp"
#include "planner/returns/exact.hpp"
#include "planner/returns/refine.hpp"
#include "planner/returns/solve.hpp"
#include "planner/returns/unplanned.hpp"
#include "tests/planner/paper_case.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>

namespace furrow::planner {
namespace {

constexpr int seeds = 30;
constexpr double paper_min = 18.98;

const ReturnProblem& field_a() {
  static const ReturnProblem problem =
      paper_case::problem(paper_case::route(paper_case::field_a()));
  return problem;
}

void over_seeds(benchmark::State& state, double budget_s, bool refine) {
  SolveSettings settings{.returns = ReturnStrategy::gsa,
                         .refine = refine,
                         .paper_counting = false,
                         .iterations = 300,
                         .masses = 50,
                         .budget_s = budget_s,
                         .seed = 0};
  std::vector<double> minutes;
  double optimum_s = 0.0;
  for (auto _ : state) {
    const auto solution = solve(field_a(), settings);
    minutes.push_back(solution->objective_s / 60.0);
    optimum_s = solution->lower_bound_s;
    ++settings.seed;
  }
  const auto [best, worst] = std::minmax_element(minutes.begin(), minutes.end());
  double sum = 0.0;
  for (const double m : minutes) sum += m;
  state.counters["best_min"] = *best;
  state.counters["mean_min"] = sum / static_cast<double>(minutes.size());
  state.counters["worst_min"] = *worst;
  state.counters["paper_min"] = paper_min;
  state.counters["optimum_min"] = optimum_s / 60.0;
  state.counters["gap_worst"] = *worst * 60.0 / optimum_s - 1.0;
}
BENCHMARK_CAPTURE(over_seeds, gsa_1s, 1.0, false)->Iterations(seeds)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(over_seeds, gsa_10s, 10.0, false)
    ->Iterations(seeds)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(over_seeds, gsa_and_refinement_1s, 1.0, true)
    ->Iterations(seeds)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(over_seeds, gsa_and_refinement_10s, 10.0, true)
    ->Iterations(seeds)
    ->Unit(benchmark::kMillisecond);

void light_cost(benchmark::State& state) {
  const ReturnCost cost{field_a()};
  const Returns returns = unplanned_plan(field_a())->returns;
  for (auto _ : state) benchmark::DoNotOptimize(cost(returns));
}
BENCHMARK(light_cost);

void refinement(benchmark::State& state) {
  const ExtraCost none;
  const Returns start = unplanned_plan(field_a())->returns;
  for (auto _ : state) {
    ReturnObjective objective{field_a(), none};
    state.counters["objective_s"] = refined(field_a(), start, objective).objective_s;
  }
}
BENCHMARK(refinement)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace furrow::planner
