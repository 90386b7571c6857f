#include "planner/avoidance/detour.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {

bool crosses(FieldPoint from, FieldPoint to, const Circle& circle) {
  const double ax = (to.x - from.x).base(), ay = (to.y - from.y).base();
  const double bx = (circle.center.x - from.x).base(), by = (circle.center.y - from.y).base();
  const double squared = ax * ax + ay * ay;
  const double share = squared > 0 ? std::clamp((ax * bx + ay * by) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(bx - share * ax, by - share * ay) < circle.radius.base();
}

Beside replaced(Beside obstacle, Length turn_radius, Side side) {
  if (obstacle.radius >= turn_radius) return obstacle;
  return {obstacle.left - sign(side) * (turn_radius - obstacle.radius), turn_radius};
}

DetourShape detour_shape(Beside target, Length turn_radius, Side side) {
  const Beside circle = replaced(target, turn_radius, side);
  const double centers_m = (turn_radius + circle.radius).base();
  const double across_m = (turn_radius - sign(side) * circle.left).base();
  require(turn_radius > Length{} && std::abs(across_m) <= centers_m, "a detour is for a target");
  const double reach_m = std::sqrt(centers_m * centers_m - across_m * across_m);
  const double turn_rad = std::acos(across_m / centers_m);
  return {metres(reach_m), turn_rad, metres(2 * centers_m * turn_rad - 2 * reach_m)};
}

Length pass_length(Length straight, std::span<const DetourShape> detours) {
  Length sum = straight;
  for (const DetourShape& detour : detours) sum += detour.extra;
  return sum;
}

}  // namespace furrow::planner
