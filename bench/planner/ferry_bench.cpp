// A map of what ferries cost: there and back, to each of 10 000 cells, from nothing.
#include "planner/ferry/ferry_map.hpp"
#include "tests/planner/ferry/behind_hills.hpp"

#include <benchmark/benchmark.h>

namespace furrow::planner {
namespace {

AnalyticTerrain ridge() {
  return {.base = {}, .peaks = {{at_m(200, -50), metres(55), metres(70), metres(22)}}};
}

// A hill of 20 m every 100 m, too steep for the full speed of any ferry that crosses one.
AnalyticTerrain hummocks() {
  AnalyticTerrain ground{};
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; j <= 4; ++j) {
      ground.peaks.push_back({at_m(100 * i, 100 * j - 40), metres(20), metres(25), metres(25)});
    }
  }
  return ground;
}

void map_of_10000_cells(benchmark::State& state, const AnalyticTerrain& ground,
                        const std::optional<RouteSettings>& search) {
  const Field field{.boundary = {at_m(0, 0), at_m(400, 0), at_m(400, 400), at_m(0, 400)},
                    .holes = {},
                    .obstacles = {}};
  const std::vector<FieldPoint> stands{station};
  const auto level = FerryMap::over(field, {.corner_cut = metres(2)}, stands);
  const Relief relief{TerrainModel{.ground = ground}, {at_m(-200, -300), at_m(600, 430)}};
  const Vehicle& v = aircraft;
  double sum_s = 0;
  for (auto _ : state) {
    const FerryMap map = level->over_ground(relief, search);
    sum_s = 0;
    const auto fly = [&](FieldPoint from, FieldPoint to) {
      sum_s += relief.cost(from, relief.ferry(map.ferry_way(from, to, v), v)).time_s;
    };
    for (int i = 0; i < 100; ++i) {
      for (int j = 0; j < 100; ++j) {
        const FieldPoint cell = at_m(2 + 4 * i, 2 + 4 * j);
        fly(station, cell);
        fly(cell, station);
      }
    }
    benchmark::DoNotOptimize(sum_s);
  }
  state.counters["mean_ferry_s"] = sum_s / 20'000;
}

constexpr RouteSettings lattice{.evaluations = 1000};
BENCHMARK_CAPTURE(map_of_10000_cells, ridge_shortest, ridge(), std::nullopt)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(map_of_10000_cells, ridge_lattice, ridge(), lattice)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(map_of_10000_cells, hummocks_shortest, hummocks(), std::nullopt)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(map_of_10000_cells, hummocks_lattice, hummocks(), lattice)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace furrow::planner
