#pragma once
// Plane vectors of raw doubles for the control loop. Public doors speak in quantities; past
// `xy_m` everything is in metres and seconds, x east and y north.

#include "core/geometry.hpp"

#include <cmath>

namespace furrow::agents {

struct Xy {
  double x = 0.0, y = 0.0;

  friend constexpr bool operator==(Xy a, Xy b) = default;
  friend constexpr Xy operator+(Xy a, Xy b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Xy operator-(Xy a, Xy b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Xy operator*(double k, Xy a) { return {k * a.x, k * a.y}; }
};

constexpr double dot(Xy a, Xy b) { return a.x * b.x + a.y * b.y; }
inline double norm(Xy a) { return std::sqrt(dot(a, a)); }

/// The unit vector to the right of one that looks ahead.
constexpr Xy right_of(Xy ahead) { return {ahead.y, -ahead.x}; }

/// `a`, shortened to `limit` where it is longer.
inline Xy limited(Xy a, double limit) {
  const double length = norm(a);
  return length <= limit ? a : (limit / length) * a;
}

inline Xy xy_m(FieldPoint p) { return {p.x.base(), p.y.base()}; }
inline FieldPoint field_point(Xy p_m) { return at_m(p_m.x, p_m.y); }

}  // namespace furrow::agents
