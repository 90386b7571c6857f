// The split of fifty rows anywhere along them: width of the bracket and time by length of cell.
#include "planner/returns/continuous_bracket.hpp"
#include "planner/returns/unplanned.hpp"
#include "tests/planner/field_a_rows.hpp"

#include <benchmark/benchmark.h>

namespace furrow::planner {
namespace {

// Argument: length of a cell in centimetres.
void bracket_of_fifty_rows(benchmark::State& state) {
  const Length cell = metres(0.01 * static_cast<double>(state.range(0)));
  const ReturnProblem problem = field_a_rows::problem(field_a_rows::route(cell));
  for (auto _ : state) {
    const auto bracket = continuous_bracket(problem);
    state.counters["flown_m"] = 5.0 * bracket->mission_upper_s;
    state.counters["bound_m"] = 5.0 * bracket->mission_lower_s;
    state.counters["gap_percent"] = 100.0 * bracket->gap();
    state.counters["proven"] = bracket->upper.proven;
  }
  state.counters["until_empty_m"] = field_a_rows::flown_m(*unplanned_plan(problem));
}
BENCHMARK(bracket_of_fifty_rows)
    ->Arg(200)
    ->Arg(100)
    ->Arg(50)
    ->Arg(20)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace furrow::planner
