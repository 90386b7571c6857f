#include "planner/coverage/swath/part_plan.hpp"
#include "planner/coverage/swath/swath.hpp"

#include <benchmark/benchmark.h>
#include <cmath>
#include <numbers>

namespace {

using namespace furrow;
using namespace furrow::planner;

// A bent field with a dent and a hole, `side_m` across.
Field bent_field(double side_m) {
  const auto p = [&](double x, double y) { return at_m(side_m * x, side_m * y); };
  return {.boundary = {p(0, 0), p(0.6, -0.05), p(1, 0.1), p(0.95, 0.6), p(0.7, 0.55), p(0.65, 1),
                       p(0.1, 0.9)},
          .holes = {{p(0.3, 0.3), p(0.4, 0.3), p(0.4, 0.45), p(0.3, 0.45)}},
          .obstacles = {}};
}

// A winding strip of land, `corners` vertices on each bank.
Field river_bend(int corners) {
  Field field;
  const auto bank = [&](int i, double wide_m) {
    const double x = 1000.0 * i / corners;
    return at_m(x, 120 * std::sin(x / 1000 * 2 * std::numbers::pi) + wide_m);
  };
  for (int i = 0; i <= corners; ++i) field.boundary.push_back(bank(i, 0));
  for (int i = corners; i >= 0; --i) field.boundary.push_back(bank(i, 100));
  return field;
}

void report(benchmark::State& state, const SwathCoverage& c) {
  state.counters["strips"] = static_cast<double>(c.strips.size());
  state.counters["covered"] = (c.areas.covered / (c.areas.covered + c.areas.missed)).base();
  state.counters["route_over_bound"] = (c.route / c.order_bound).base();
}

void plan(benchmark::State& state, const Field& field, const SwathSettings& settings) {
  for (auto _ : state) {
    const auto c = swath_coverage(field, metres(2), settings);
    benchmark::DoNotOptimize(c);
  }
  report(state, *swath_coverage(field, metres(2), settings));
}

void bent(benchmark::State& state) {
  plan(state, bent_field(static_cast<double>(2 * state.range(0))), {});
}
BENCHMARK(bent)->RangeMultiplier(2)->Range(25, 1600)->UseRealTime()->Unit(benchmark::kMillisecond);

void river(benchmark::State& state) {
  plan(state, river_bend(static_cast<int>(state.range(0))), {});
}
BENCHMARK(river)->Arg(20)->Arg(200)->Arg(1000)->UseRealTime()->Unit(benchmark::kMillisecond);

void thousand_hectares(benchmark::State& state) {
  const double s = std::sqrt(1e7);
  plan(state,
       {.boundary = {at_m(0, 0), at_m(s, 0.02 * s), at_m(0.99 * s, s), at_m(0.01 * s, s)},
        .holes = {},
        .obstacles = {}},
       {});
}
BENCHMARK(thousand_hectares)->UseRealTime()->Unit(benchmark::kMillisecond);

void direction_search(benchmark::State& state) {
  const auto land = field_land(bent_field(380), Length{}, Length{});
  const PlanRule rule{2, 2, 0, {}, std::nullopt};
  for (auto _ : state) benchmark::DoNotOptimize(ranked_directions(land->flight, rule, 3));
}
BENCHMARK(direction_search)->Unit(benchmark::kMillisecond);

}  // namespace
