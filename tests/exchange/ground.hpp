#pragma once
// What the tests know of the globe and of polygons, apart from the code under test.

#include "exchange/land.hpp"

#include <cmath>

namespace furrow::exchange::ground {

constexpr double degree = M_PI / 180;

/// Radii of curvature of WGS84 (a = 6378137 m, 1/f = 298.257223563) in metres: along the meridian
/// and across it.
inline double meridian_radius_m(double lat_deg) {
  const double e2 = 0.00669437999014, s = std::sin(lat_deg * degree);
  return 6378137.0 * (1 - e2) / std::pow(1 - e2 * s * s, 1.5);
}
inline double prime_vertical_radius_m(double lat_deg) {
  const double e2 = 0.00669437999014, s = std::sin(lat_deg * degree);
  return 6378137.0 / std::sqrt(1 - e2 * s * s);
}

/// Area between two parallels and two meridians, from its middle latitude; exact to 1e-8 for
/// hundredths of a degree.
inline double quad_m2(double mid_lat_deg, double height_deg, double width_deg) {
  return meridian_radius_m(mid_lat_deg) * height_deg * degree *
         prime_vertical_radius_m(mid_lat_deg) * std::cos(mid_lat_deg * degree) * width_deg * degree;
}

inline double ring_m2(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const FieldPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    twice += a.x.base() * b.y.base() - b.x.base() * a.y.base();
  }
  return std::abs(twice) / 2;
}

/// Boundary less holes.
inline double area_m2(const Field& field) {
  double area = ring_m2(field.boundary);
  for (const Ring& hole : field.holes) area -= ring_m2(hole);
  return area;
}

}  // namespace furrow::exchange::ground
