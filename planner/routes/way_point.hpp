#pragma once
// Places in the air while a search holds millions of them: raw metres in the field frame.

#include <cmath>

namespace furrow::planner {

struct WayPoint {
  double x_m, y_m;  ///< East and north.
  double z_m;       ///< Above the datum.
  friend constexpr bool operator==(const WayPoint&, const WayPoint&) = default;
};

inline double distance_m(WayPoint a, WayPoint b) {
  return std::sqrt((a.x_m - b.x_m) * (a.x_m - b.x_m) + (a.y_m - b.y_m) * (a.y_m - b.y_m) +
                   (a.z_m - b.z_m) * (a.z_m - b.z_m));
}

/// The place a share `t` of the way from `a` to `b`.
constexpr WayPoint between(WayPoint a, WayPoint b, double t) {
  return {a.x_m + t * (b.x_m - a.x_m), a.y_m + t * (b.y_m - a.y_m), a.z_m + t * (b.z_m - a.z_m)};
}

}  // namespace furrow::planner
