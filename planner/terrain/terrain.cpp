#include "planner/terrain/terrain.hpp"

#include "core/require.hpp"

#include <cmath>

namespace furrow::planner {
namespace {

constexpr double most_samples = 1 << 22;
constexpr double widest_step_m = 64;

// Halved from the widest until the error fits or the samples run out.
double step_m(const AnalyticTerrain& terrain, double width_m, double depth_m, Length tolerance) {
  double step = widest_step_m;
  const auto samples = [&](double s) { return (width_m / s + 2) * (depth_m / s + 2); };
  while (interpolation_error(terrain, metres(step)) > tolerance) {
    const double finer = step / 1.25;
    if (samples(finer) > most_samples) break;
    step = finer;
  }
  return step;
}

Surface tabulated(const AnalyticTerrain& terrain, const Extent& extent, Length tolerance) {
  const double width_m = (extent.north_east.x - extent.south_west.x).base();
  const double depth_m = (extent.north_east.y - extent.south_west.y).base();
  require(width_m > 0 && depth_m > 0, "an extent has an area");
  const double step = step_m(terrain, width_m, depth_m, tolerance);
  Raster raster{.south_west = extent.south_west,
                .step = metres(step),
                .columns = static_cast<std::uint32_t>(std::ceil(width_m / step)) + 1,
                .rows = static_cast<std::uint32_t>(std::ceil(depth_m / step)) + 1,
                .heights_m = {}};
  raster.heights_m.reserve(std::size_t{raster.columns} * raster.rows);
  double largest_m = 0;
  for (std::uint32_t j = 0; j < raster.rows; ++j) {
    for (std::uint32_t i = 0; i < raster.columns; ++i) {
      const FieldPoint p = extent.south_west + FieldVector{metres(i * step), metres(j * step)};
      const double h = height(terrain, p).base();
      largest_m = std::max(largest_m, std::abs(h));
      raster.heights_m.push_back(static_cast<float>(h));
    }
  }
  const Length rounding = metres(largest_m * 0x1.0p-22);  // of the floats, twice over
  return Surface{std::move(raster), interpolation_error(terrain, metres(step)) + rounding};
}

}  // namespace

Surface surface(const Terrain& terrain, const Extent& extent, Length tolerance) {
  require(tolerance > Length{}, "a tolerance is more than nothing");
  if (const auto* formula = std::get_if<AnalyticTerrain>(&terrain)) {
    return tabulated(*formula, extent, tolerance);
  }
  return Surface{std::get<Raster>(terrain)};
}

}  // namespace furrow::planner
