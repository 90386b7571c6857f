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

// As scenarios/orchard_trees.yaml: 30 trees scattered over 7.2 ha.
Field scattered() {
  constexpr double trees[][3] = {
      {20.9, 233.9, 1.1},  {21.4, 208.8, 2.0},  {22.7, 91.9, 1.0},   {27.8, 257.9, 1.3},
      {30.7, 198.6, 1.0},  {34.1, 276.7, 1.9},  {38.6, 130.0, 0.7},  {38.9, 81.1, 1.0},
      {44.9, 22.8, 1.1},   {45.5, 134.4, 0.7},  {50.2, 260.3, 1.0},  {54.7, 214.6, 1.9},
      {58.8, 93.3, 1.2},   {72.6, 230.7, 1.5},  {80.6, 181.6, 0.7},  {91.3, 199.4, 1.5},
      {96.5, 220.7, 0.7},  {100.0, 239.0, 0.5}, {114.7, 190.9, 1.5}, {122.4, 230.6, 1.3},
      {124.0, 77.8, 1.1},  {130.5, 66.3, 1.5},  {140.2, 144.0, 1.1}, {141.3, 165.1, 1.5},
      {148.8, 33.5, 1.2},  {161.3, 33.4, 0.8},  {186.3, 124.1, 1.1}, {205.3, 35.3, 1.7},
      {216.3, 145.1, 1.9}, {220.0, 192.5, 1.0}};
  Field field{{at_m(0, 0), at_m(240, 0), at_m(240, 300), at_m(0, 300)}, {}, {}};
  for (const auto& [x, y, radius] : trees) {
    const std::string id = std::to_string(field.obstacles.size());
    field.obstacles.push_back({id, at_m(x, y), metres(radius)});
  }
  return field;
}

// As scenarios/pylon_line.yaml: 14 poles 20 m apart across the rows.
Field poles() {
  Field field{{at_m(0, 0), at_m(240, 0), at_m(240, 300), at_m(0, 300)}, {}, {}};
  for (int i = 0; i < 14; ++i) {
    field.obstacles.push_back({std::to_string(i), at_m(70 + i * 6.84, 20 + i * 18.8), metres(0.5)});
  }
  return field;
}

struct Spread {
  double least = INFINITY, sum = 0, most = 0;
  void add(double x) {
    least = std::min(least, x);
    most = std::max(most, x);
    sum += x;
  }
};

// Missed and repeated by half circles, as a multiple of ours, with all obstacles shifted across the
// rows by twentieths of a swath; `choice`: of ours over that of the exact selection.
void phases(benchmark::State& state, const Field& field, double safety_m) {
  constexpr int shifts = 20;
  const auto strips = rows(40, 300, 6);
  Spread ratio, ours_m2, classic_m2, choice;
  const auto wrong_m2 = [&](const Room& room, AvoidanceMethod method) {
    AvoidanceSettings s;
    s.turn_radius = metres(3);
    s.method = method;
    const AvoidanceFigures figures = plan_avoidance(strips, room, s).figures;
    return (figures.missed + figures.repeated).base();
  };
  for (auto _ : state) {
    for (int i = 0; i < shifts; ++i) {
      Field shifted = field;
      for (Obstacle& o : shifted.obstacles) o.center.x += metres(6.0 * i / shifts);
      const Room room = *room_of(shifted, metres(0), metres(0), metres(safety_m));
      const double ours = wrong_m2(room, AvoidanceMethod::genetic);
      const double half = wrong_m2(room, AvoidanceMethod::classic);
      ours_m2.add(ours);
      classic_m2.add(half);
      ratio.add(half / ours);
      choice.add(ours / wrong_m2(room, AvoidanceMethod::exact));
    }
  }
  state.counters["ratio_least"] = ratio.least;
  state.counters["ratio_mean"] = ratio.sum / shifts;
  state.counters["ratio_most"] = ratio.most;
  state.counters["ours_least"] = ours_m2.least;
  state.counters["ours_most"] = ours_m2.most;
  state.counters["classic_least"] = classic_m2.least;
  state.counters["classic_most"] = classic_m2.most;
  state.counters["choice_most"] = choice.most;
}
BENCHMARK_CAPTURE(phases, scattered, scattered(), 1.5)->Iterations(1);
BENCHMARK_CAPTURE(phases, poles, poles(), 2.0)->Iterations(1);

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
