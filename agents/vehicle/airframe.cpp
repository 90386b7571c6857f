#include "agents/vehicle/airframe.hpp"

#include "agents/control_clock.hpp"

#include <algorithm>

namespace furrow::agents {
namespace {

// Rotors are sized to use the whole acceleration limit at twice the ferry speed through the air.
double thrust_limit(const Vehicle& v) {
  return v.acceleration_limit.base() + drag_per_s * 2.0 * v.ferry_speed.base();
}

}  // namespace

Airframe::Airframe(const Vehicle& vehicle)
    : position_{xy_m(vehicle.home)}, thrust_limit_{thrust_limit(vehicle)} {}

void Airframe::advance(Xy thrust_mps2, Xy wind_mps) {
  drag_ = drag_per_s * (wind_mps - velocity_);
  const Xy acceleration = limited(thrust_mps2, thrust_limit_) + drag_;
  const Xy before = velocity_;
  velocity_ = velocity_ + control_period_s * acceleration;
  position_ = position_ + (0.5 * control_period_s) * (before + velocity_);
}

double headway_mps(const Vehicle& v, double head_wind_mps) {
  const double top_mps = thrust_limit(v) / drag_per_s;  // through the air
  return std::min(v.ferry_speed.base(), top_mps - head_wind_mps);
}

double workable_wind_mps(const Vehicle& v) {
  const double spare = thrust_limit(v) - 0.5 * v.acceleration_limit.base();
  return spare / drag_per_s - v.ferry_speed.base();
}

}  // namespace furrow::agents
