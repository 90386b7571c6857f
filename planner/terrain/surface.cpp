#include "planner/terrain/surface.hpp"

#include "core/require.hpp"

#include <array>
#include <cmath>

namespace furrow::planner {
namespace {

double just_under(std::uint32_t samples) { return std::nextafter(samples - 1.0, 0.0); }

}  // namespace

Surface::Surface(Raster raster, Length error)
    : raster_{std::make_shared<const Raster>(std::move(raster))},
      samples_{raster_->heights_m.data()},
      columns_{raster_->columns},
      west_m_{raster_->south_west.x.base()},
      south_m_{raster_->south_west.y.base()},
      per_step_{metres(1) / raster_->step},
      last_x_{just_under(raster_->columns)},
      last_y_{just_under(raster_->rows)},
      error_{error} {
  require(raster_->columns >= 2 && raster_->rows >= 2 && raster_->step > Length{} &&
              raster_->heights_m.size() < (std::size_t{1} << 31) &&
              raster_->heights_m.size() == std::size_t{raster_->columns} * raster_->rows,
          "a raster has a height for each of its samples, two or more on each axis, under 2^31");
}

Surface Surface::level(Length height) {
  const auto h = static_cast<float>(height.base());
  return Surface{{.south_west = at_m(0, 0),
                  .step = metres(1),
                  .columns = 2,
                  .rows = 2,
                  .heights_m = {h, h, h, h}}};
}

void Surface::heights_m(const double* x_m, const double* y_m, std::size_t n, double* into) const {
  constexpr std::size_t block = 128;
  std::array<double, block> u, v;
  std::array<std::int32_t, block> at;
  const auto columns = static_cast<std::int32_t>(columns_);
  for (; n > 0; x_m += block, y_m += block, into += block) {
    const std::size_t count = std::min(n, block);
    n -= count;
    for (std::size_t k = 0; k < count; ++k) {  // the compiler takes several at a time
      const double x = std::min(std::max((x_m[k] - west_m_) * per_step_, 0.0), last_x_);
      const double y = std::min(std::max((y_m[k] - south_m_) * per_step_, 0.0), last_y_);
      const auto i = static_cast<std::int32_t>(x), j = static_cast<std::int32_t>(y);
      u[k] = x - i;
      v[k] = y - j;
      at[k] = j * columns + i;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const float *south = samples_ + at[k], *north = south + columns_;
      const double s = south[0] + u[k] * (south[1] - south[0]);
      const double t = north[0] + u[k] * (north[1] - north[0]);
      into[k] = s + v[k] * (t - s);
    }
  }
}

Slope Surface::slope(FieldPoint p) const {
  const Cell c = cell(p.x.base(), p.y.base());
  const double sw = c.at[0], se = c.at[1], nw = c.at[columns_], ne = c.at[columns_ + 1];
  return {((1 - c.v) * (se - sw) + c.v * (ne - nw)) * per_step_,
          ((1 - c.u) * (nw - sw) + c.u * (ne - se)) * per_step_};
}

}  // namespace furrow::planner
