#include "core/random.hpp"
#include "planner/avoidance/field_plan.hpp"
#include "planner/avoidance/onboard.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>
#include <string>

using namespace furrow;
using namespace furrow::planner;

namespace {

std::vector<StraightStrip> rows(int count, double length_m, double width_m) {
  std::vector<StraightStrip> strips;
  for (int i = 0; i < count; ++i) {
    const double x = (i + 0.5) * width_m;
    const FieldPoint south = at_m(x, 0), north = at_m(x, length_m);
    strips.push_back({i % 2 == 0 ? south : north, i % 2 == 0 ? north : south, metres(width_m)});
  }
  return strips;
}

Field orchard(std::size_t trees, double width_m, double length_m) {
  Field field{{at_m(0, 0), at_m(width_m, 0), at_m(width_m, length_m), at_m(0, length_m)}, {}, {}};
  Random random{4};
  for (std::size_t i = 0; i < trees; ++i) {
    const FieldPoint at = at_m(random.uniform(20, width_m - 20), random.uniform(20, length_m - 20));
    field.obstacles.push_back({std::to_string(i), at, metres(random.uniform(0.5, 2))});
  }
  return field;
}

// 200 trees on 20 ha, 75 strips of 444 m; ratio of wrong areas to those of half circles.
void whole_field(benchmark::State& state) {
  const Room room = *room_of(orchard(200, 450, 444), metres(0), metres(0), metres(1.5));
  const auto strips = rows(75, 444, 6);
  AvoidanceSettings s;
  s.turn_radius = metres(3);
  AvoidancePlan plan;
  for (auto _ : state) plan = plan_avoidance(strips, room, s);
  s.method = AvoidanceMethod::exact;
  const AvoidancePlan exact = plan_avoidance(strips, room, s);
  s.method = AvoidanceMethod::classic;
  const AvoidanceFigures half = plan_avoidance(strips, room, s).figures;
  const AvoidanceFigures ours = plan.figures;
  state.counters["crowds"] = static_cast<double>(ours.crowds);
  state.counters["gap"] = ours.fitness / exact.figures.fitness - 1;
  state.counters["wrong_m2"] = (ours.missed + ours.repeated).base();
  state.counters["classic_m2"] = (half.missed + half.repeated).base();
  state.counters["extra_m"] = ours.extra.base();
  state.counters["classic_extra_m"] = half.extra.base();
}
BENCHMARK(whole_field)->Unit(benchmark::kMillisecond);

// 1000 scenes of up to 20 known obstacles and a new one; the worst time in ms.
void onboard(benchmark::State& state) {
  double worst_ms = 0, flown = 0;
  for (auto _ : state) {
    Random random{21};
    for (int i = 0; i < 1000; ++i) {
      std::vector<CircleM> circles{
          {{random.uniform(-3, 3), random.uniform(15, 180)}, random.uniform(2, 5)}};
      for (std::uint64_t k = random.below(20); k > 0; --k) {
        circles.push_back(
            {{random.uniform(-40, 40), random.uniform(0, 200)}, random.uniform(2, 5)});
      }
      const Room room{circles, {}, {}};
      const OnboardLine line{{at_m(random.uniform(-0.3, 0.3), 1), random.uniform(1.5, 1.64)},
                             at_m(0, 0),
                             at_m(0, 200),
                             metres(6)};
      const auto begin = std::chrono::steady_clock::now();
      const auto detour = onboard_detour(line, room, metres(3));
      const std::chrono::duration<double, std::milli> took =
          std::chrono::steady_clock::now() - begin;
      worst_ms = std::max(worst_ms, took.count());
      flown += detour.has_value() ? 1 : 0;
    }
  }
  state.counters["worst_ms"] = worst_ms;
  state.counters["flown"] = flown / static_cast<double>(state.iterations());
}
BENCHMARK(onboard)->Unit(benchmark::kMillisecond);

}  // namespace
