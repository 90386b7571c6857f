#pragma once

#include "core/raster.hpp"

#include <algorithm>
#include <memory>

namespace furrow::planner {

/// Rise over run eastwards and northwards.
struct Slope {
  double east, north;
};

/// Terrain that is asked for often: bilinear between the samples of a raster, level beyond its
/// edges. A copy shares the samples.
class Surface {
 public:
  /// @param error  How far the surface may lie under the true terrain, >= 0.
  /// @pre the raster is whole: columns, rows >= 2, step > 0, one finite height per sample
  explicit Surface(Raster raster, Length error = {});

  /// Level ground at `height`.
  static Surface level(Length height);

  /// In 3 ns where samples are at hand in a cache.
  double height_m(double x_m, double y_m) const {
    const Cell c = cell(x_m, y_m);
    const double south = c.at[0] + c.u * (c.at[1] - c.at[0]);
    const double north = c.at[columns_] + c.u * (c.at[columns_ + 1] - c.at[columns_]);
    return south + c.v * (north - south);
  }
  /// The same for `n` places at once, at half the cost.
  void heights_m(const double* x_m, const double* y_m, std::size_t n, double* into) const;
  Length height(FieldPoint p) const { return metres(height_m(p.x.base(), p.y.base())); }

  /// Of the bilinear surface; of the cell to the north-east where `p` lies on a line of the grid.
  Slope slope(FieldPoint p) const;

  /// Whoever keeps this and a clearance from the surface keeps the clearance from the terrain.
  Length error() const { return error_; }
  const Raster& raster() const { return *raster_; }

 private:
  struct Cell {
    const float* at;  // its south-west sample
    double u, v;      // place within, 0 to 1
  };
  Cell cell(double x_m, double y_m) const {
    const double x = std::clamp((x_m - west_m_) * per_step_, 0.0, last_x_);
    const double y = std::clamp((y_m - south_m_) * per_step_, 0.0, last_y_);
    const auto i = static_cast<std::int32_t>(x), j = static_cast<std::int32_t>(y);
    return {samples_ + static_cast<std::ptrdiff_t>(j) * static_cast<std::ptrdiff_t>(columns_) + i,
            x - i, y - j};
  }

  std::shared_ptr<const Raster> raster_;
  const float* samples_;
  std::size_t columns_;
  double west_m_, south_m_, per_step_;
  double last_x_, last_y_;  // just under the last column and row
  Length error_;
};

}  // namespace furrow::planner
