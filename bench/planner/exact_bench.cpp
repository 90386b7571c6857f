// The exact solver on the paper's fields, and the coverage of a hundred hectares.
#include "planner/returns/exact.hpp"
#include "tests/planner/paper_case.hpp"

#include <benchmark/benchmark.h>

namespace furrow::planner {
namespace {

void exact(benchmark::State& state, const Field& field) {
  const ReturnProblem problem = paper_case::problem(paper_case::route(field));
  for (auto _ : state) {
    const auto result = exact_plan(problem);
    state.counters["objective_s"] = result->plan.non_spray_s;
    state.counters["bound_s"] = result->lower_bound_s;
    state.counters["proven"] = result->proven;
    state.counters["work"] = static_cast<double>(result->work);
  }
}
BENCHMARK_CAPTURE(exact, field_a, paper_case::field_a())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exact, field_b, paper_case::field_b())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exact, 600m_x_150m, paper_case::field(150, 600))->Unit(benchmark::kMillisecond);

void grid_and_walk(benchmark::State& state, const Field& field) {
  for (auto _ : state) {
    const auto route = coverage_route(field, metres(2), {});
    state.counters["cells"] = static_cast<double>(route->centers.size());
    state.counters["missed"] = static_cast<double>(route->missed.size());
  }
}
BENCHMARK_CAPTURE(grid_and_walk, 100_ha, paper_case::field(1000, 1000))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(grid_and_walk, 100_ha_triangle,
                  Field{.boundary = {at_m(0, 0), at_m(2000, 0), at_m(700, 1000)},
                        .holes = {},
                        .obstacles = {}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace furrow::planner
