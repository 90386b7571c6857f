#pragma once

#include "core/geometry.hpp"

#include <optional>
#include <vector>

namespace furrow::planner {

/// h exp(-((x - x_i) / x_s)^2 - ((y - y_i) / y_s)^2).
struct Peak {
  FieldPoint top;
  Length height;
  Length extent_x, extent_y;  ///< x_s and y_s, > 0.
};

/// Rolling ground, in units of its own:
///
///     Z1 = sin(y + a) + b sin x + c cos(d r) + e cos y + f sin(g r),   r = sqrt(x^2 + y^2)
struct BaseTerrain {
  double a, b, c, d, e, f, g;
  Length wave = metres(1);  ///< One unit of x and y, > 0.
  Length rise = metres(1);  ///< One unit of height.
};

/// Terrain by formula: the higher of the base and the sum of the peaks.
/// Source: Huang, Tian, Qiao, Wang, Su, "UAV path planning based on improved genetic algorithm".
struct AnalyticTerrain {
  std::optional<BaseTerrain> base;
  std::vector<Peak> peaks;
};

/// Height of the terrain at `p`, exact.
Length height(const AnalyticTerrain& terrain, FieldPoint p);

/// How far bilinear interpolation between exact heights on a square grid of `step` can lie under
/// the terrain, anywhere.
///
/// A function with |f_xx| <= A and |f_yy| <= B differs from its bilinear interpolant by at most
/// step^2 (A + B) / 8; one with a gradient of at most L by L step / sqrt 2, which serves the cone
/// of sin(g r) at the origin. Of a maximum of two the interpolant lies no lower than the higher of
/// their interpolants.
Length interpolation_error(const AnalyticTerrain& terrain, Length step);

}  // namespace furrow::planner
