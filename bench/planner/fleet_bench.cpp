// Fleets on one path: how long it takes to plan and to bound them.

#include "planner/fleet/bound.hpp"
#include "planner/fleet/solve.hpp"
#include "planner/fleet/work_bound.hpp"
#include "tests/planner/fleet/yardsticks.hpp"

#include <benchmark/benchmark.h>
#include <string>

namespace furrow::planner::fleet {
namespace {

/// Solves `p`, and publishes makespans beside the best bound, which is returned.
LowerBound judge(benchmark::State& state, const FleetProblem& p) {
  FleetSolution solution{};
  for (auto _ : state) solution = *solved(p);
  const LowerBound bound = best_bound(p);
  state.counters["till_empty_s"] = solution.till_empty_s;
  state.counters["solved_s"] = solution.finish.makespan_s;
  state.counters["bound_s"] = bound.makespan_s;
  state.counters["gap_%"] = 100.0 * (solution.finish.makespan_s / bound.makespan_s - 1.0);
  return bound;
}

/// A row of the yardsticks.
void yardstick(benchmark::State& state) {
  const yardsticks::Yardstick& y = yardsticks::all[static_cast<std::size_t>(state.range(0))];
  const LowerBound bound = judge(state, yardsticks::problem(y));
  state.SetLabel(std::string{bound.name});
}
BENCHMARK(yardstick)->DenseRange(0, 6)->Unit(benchmark::kMillisecond)->Iterations(1);

void yardstick_bound(benchmark::State& state) {
  const FleetProblem p =
      yardsticks::problem(yardsticks::all[static_cast<std::size_t>(state.range(0))]);
  for (auto _ : state) benchmark::DoNotOptimize(best_bound(p));
}
BENCHMARK(yardstick_bound)->DenseRange(0, 6)->Unit(benchmark::kMillisecond);

/// Ten aircraft on field A at growing budgets: how soon the makespan is near its last.
void budget(benchmark::State& state) {
  const FleetProblem p = yardsticks::problem(yardsticks::all[1]);
  FleetSolution solution{};
  for (auto _ : state)
    solution = *solved(p, {.budget = static_cast<std::uint64_t>(state.range(0))});
  state.counters["solved_s"] = solution.finish.makespan_s;
}
BENCHMARK(budget)
    ->RangeMultiplier(10)
    ->Range(10'000, 100'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

/// So many aircraft, ten rows of field A and a tenth of a bay for each.
void growth(benchmark::State& state) {
  const auto fliers = static_cast<std::uint32_t>(state.range(0));
  std::vector<StraightStrip> strips;
  for (std::uint32_t row = 0; row < 10 * fliers; ++row) {
    FieldPoint begin = at_m(0, 2.0 * row + 1.0), end = at_m(700, 2.0 * row + 1.0);
    if (row % 2 == 1) std::swap(begin, end);
    strips.push_back({begin, end});
  }
  FleetProblem p{StripPath{strips}, {}, {}};
  const std::uint32_t depots = (fliers + 9) / 10;
  for (std::uint32_t d = 0; d < depots; ++d) {
    const double y_m = 20.0 * fliers * (d + 0.5) / depots;
    p.depots.push_back({at_m(-10, y_m), 1, 60.0});
  }
  for (std::uint32_t u = 0; u < fliers; ++u) {
    p.fliers.push_back({.tank_m = 2222,
                        .spray_mps = 5,
                        .ferry_mps = 5,
                        .start = p.depots[u * depots / fliers].position});
  }
  judge(state, p);
}
BENCHMARK(growth)
    ->RangeMultiplier(10)
    ->Range(1, 1000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace
}  // namespace furrow::planner::fleet
