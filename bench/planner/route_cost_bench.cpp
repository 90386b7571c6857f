// What it costs to judge one curve of 101 samples by 7 inner way points, scattered over the whole
// scene as at the start of a search, and along the straight line as at its end.
#include "planner/routes/population.hpp"
#include "tests/planner/routes/hills.hpp"

#include <benchmark/benchmark.h>

namespace furrow::planner {
namespace {

constexpr std::size_t inner = 7;

std::vector<Genes> curves(const Scene& scene, bool scatter) {
  Random random{1};
  std::vector<Genes> all(1000);
  for (Genes& genes : all) {
    for (std::size_t i = 0; i < inner; ++i) {
      const double t = static_cast<double>(i + 1) / (inner + 1);
      genes.push_back(scatter ? scattered(scene, random)
                              : moved(scene, between(scene.start, scene.goal, t), random));
    }
  }
  return all;
}

void judge_all(benchmark::State& state, const Scene& scene, bool scatter) {
  const auto all = curves(scene, scatter);
  RouteJudge judge{scene};
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(judge.cost(all[i++ % all.size()]).total());
}

void analytic(benchmark::State& state, bool scatter) { judge_all(state, hills::scene(1), scatter); }
BENCHMARK_CAPTURE(analytic, scattered, true);
BENCHMARK_CAPTURE(analytic, along, false);

// The same hills as a raster of 4000 x 4000 samples.
void raster_4000(benchmark::State& state, bool scatter) {
  constexpr std::uint32_t n = 4000;
  Scene scene = hills::scene(1);
  Raster raster{.south_west = at_m(0, 0),
                .step = metres(hills::side_m / (n - 1)),
                .columns = n,
                .rows = n,
                .heights_m = {}};
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      raster.heights_m.push_back(static_cast<float>(
          scene.surface.height_m(i * raster.step.base(), j * raster.step.base())));
    }
  }
  scene.surface = Surface{std::move(raster)};
  judge_all(state, scene, scatter);
}
BENCHMARK_CAPTURE(raster_4000, scattered, true);
BENCHMARK_CAPTURE(raster_4000, along, false);

}  // namespace
}  // namespace furrow::planner
