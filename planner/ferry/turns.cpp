#include "planner/ferry/turns.hpp"

namespace furrow::planner {

double turn_loss_s(FieldPoint before, FieldPoint at, FieldPoint after, Corner corner,
                   const Vehicle& vehicle) {
  const double angle_rad = turn_rad(at - before, after - at);
  const double leg_m = std::min(distance(before, at), distance(at, after)).base();
  if (leg_m == 0 || angle_rad <= straight_rad) return 0;
  const double full_mps = vehicle.ferry_speed.base();
  const double acceleration = planned_acceleration(vehicle).base();
  const auto [cut_m, radius_m] = corner_arc(corner, angle_rad, leg_m, 0.5 * vehicle.swath.base(),
                                            vehicle.min_turn_radius.base());
  if (radius_m == 0) return full_mps / acceleration;
  const double arc_mps = std::min(full_mps, arc_speed_mps(acceleration, radius_m));
  const double slower_mps = full_mps - arc_mps;
  return slower_mps * slower_mps / (acceleration * full_mps) + radius_m * angle_rad / arc_mps -
         2 * cut_m / full_mps;
}

double rest_loss_s(const Vehicle& vehicle) {
  return 0.5 * (vehicle.ferry_speed / planned_acceleration(vehicle)).base();
}

}  // namespace furrow::planner
