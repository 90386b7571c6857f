#pragma once

#include "planner/routes/way_point.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace furrow::planner {

/// Most way points of one curve.
inline constexpr std::size_t most_way_points = 64;

/// Samples of a curve: parameter steps of 0.01 from start to goal.
inline constexpr std::size_t curve_samples = 101;

/// The uniform cubic B-spline through way points, span by span as polynomials.
class Spline {
 public:
  /// Solves C_(i-1) + 4 C_i + C_(i+1) = 6 P_i for the control points C. End conditions: no bend at
  /// either end (the natural spline), so C_0 = P_0, C_n = P_n, and the phantom controls beyond
  /// mirror their neighbours.
  ///
  /// @pre 2 to `most_way_points` way points
  explicit Spline(std::span<const WayPoint> way_points);

  std::size_t spans() const { return spans_; }

  struct Axis {
    double c0, c1, c2, c3;  ///< c0 + c1 t + c2 t^2 + c3 t^3 for 0 <= t <= 1
  };
  struct Span {
    Axis x, y, z;
  };
  const Span& span(std::size_t i) const { return polynomials_[i]; }

  /// The place at parameter `u` from 0 to 1.
  WayPoint at(double u) const;

 private:
  std::size_t spans_;
  std::array<Span, most_way_points - 1> polynomials_;
};

/// A curve at `curve_samples` equal steps of its parameter.
struct SampledCurve {
  alignas(32) std::array<double, curve_samples> x_m, y_m, z_m;
};

void sample(const Spline& spline, SampledCurve& into);

/// The sharpest bend over the samples, 1/m, in the plane; a halt and turn counts as infinite.
double largest_curvature(const Spline& spline);

}  // namespace furrow::planner
