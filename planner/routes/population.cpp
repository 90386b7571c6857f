#include "planner/routes/population.hpp"

#include <algorithm>

namespace furrow::planner {

WayPoint scattered(const Scene& scene, Random& random) {
  const double x = random.uniform(scene.low.x_m, scene.high.x_m);
  const double y = random.uniform(scene.low.y_m, scene.high.y_m);
  return {x, y, random.uniform(scene.low.z_m, scene.high.z_m)};
}

WayPoint moved(const Scene& scene, WayPoint p, Random& random) {
  const double share = std::exp2(-6 * random.uniform());
  const auto shifted = [&](double v, double low, double high) {
    return std::clamp(v + share * (high - low) * random.uniform(-1, 1), low, high);
  };
  const double x = shifted(p.x_m, scene.low.x_m, scene.high.x_m);
  const double y = shifted(p.y_m, scene.low.y_m, scene.high.y_m);
  return {x, y, shifted(p.z_m, scene.low.z_m, scene.high.z_m)};
}

}  // namespace furrow::planner
