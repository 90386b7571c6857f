#pragma once
// Random hilly scenes of one kilometre, a function of their number.

#include "core/random.hpp"
#include "planner/routes/scene.hpp"
#include "planner/terrain/terrain.hpp"

namespace furrow::planner::hills {

inline constexpr double side_m = 1000, ceiling_m = 160;

inline AnalyticTerrain terrain(std::uint64_t number) {
  Random random{seed_for(number, {1})};
  AnalyticTerrain hills{.base = BaseTerrain{.a = random.uniform(0, 6),
                                            .b = 0.5,
                                            .c = 1,
                                            .d = 0.5,
                                            .e = 0.5,
                                            .f = 0.2,
                                            .g = 0.5,
                                            .wave = metres(60),
                                            .rise = metres(6)},
                        .peaks = {}};
  const std::uint64_t peaks = 6 + random.below(9);
  for (std::uint64_t i = 0; i < peaks; ++i) {
    const double x = random.uniform(0, side_m), y = random.uniform(0, side_m);
    const double height = random.uniform(60, 220), wide = random.uniform(50, 140);
    hills.peaks.push_back({.top = at_m(x, y),
                           .height = metres(height),
                           .extent_x = metres(wide),
                           .extent_y = metres(wide * random.uniform(0.6, 1.6))});
  }
  return hills;
}

/// Start and goal in opposite corners of the box, 20 m over the ground or, where the ground
/// leaves no room under the ceiling, at the ceiling.
inline Scene scene(std::uint64_t number, std::size_t volumes = 0) {
  const Extent extent{at_m(0, 0), at_m(side_m, side_m)};
  Scene scene{.surface = surface(terrain(number), extent, metres(0.25)),
              .low = {0, 0, -30},
              .high = {side_m, side_m, ceiling_m},
              .clearance_m = 10,
              .start = {},
              .goal = {}};
  const auto above = [&](double x_m, double y_m) {
    return WayPoint{x_m, y_m, std::min(scene.surface.height_m(x_m, y_m) + 20, ceiling_m)};
  };
  scene.start = above(20, 30);
  scene.goal = above(970, 980);
  Random random{seed_for(number, {2})};
  for (std::size_t i = 0; i < volumes; ++i) {
    const double x_m = random.uniform(150, 850), y_m = random.uniform(150, 850);
    scene.keep_out.push_back({.x_m = x_m, .y_m = y_m, .radius_m = random.uniform(30, 100)});
  }
  return scene;
}

}  // namespace furrow::planner::hills
