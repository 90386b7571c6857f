#pragma once

#include "planner/routes/way_point.hpp"
#include "planner/terrain/surface.hpp"

#include <limits>
#include <vector>

namespace furrow::planner {

/// Upright cylinder that no route enters.
struct KeepOut {
  double x_m, y_m;                                             ///< Its axis.
  double radius_m;                                             ///< > 0
  double bottom_m = -std::numeric_limits<double>::infinity();  ///< Above the datum, < top.
  double top_m = std::numeric_limits<double>::infinity();
};

/// Where a route is looked for, and what it must respect.
struct Scene {
  Surface surface;
  WayPoint low, high;  ///< Corners of the allowed box, low < high on each axis.
  std::vector<KeepOut> keep_out = {};
  double clearance_m;  ///< Least height above the terrain, >= 0.
  WayPoint start, goal;
  double steepest_climb = std::numeric_limits<double>::infinity();  ///< Rise over run, both ways.
  double least_turn_radius_m = 0;                                   ///< 0: turns on the spot.
};

/// Least height above the surface that keeps the clearance from the true terrain.
inline double kept_m(const Scene& scene) {
  return scene.clearance_m + scene.surface.error().base();
}

/// Whether a place respects terrain, box and keep-out volumes.
bool is_clear(const Scene& scene, WayPoint p);

}  // namespace furrow::planner
