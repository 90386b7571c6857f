#pragma once

#include "agents/xy.hpp"
#include "core/vehicle.hpp"

namespace furrow::agents {

/// A multirotor as a point that thrust accelerates and moving air drags along. It flies in any
/// direction, whichever way it looks. In plan: take-off and landing take no time.
class Airframe {
 public:
  explicit Airframe(const Vehicle& vehicle);

  /// Moves through one control period under `thrust` [m/s2, horizontal], which is cut to what the
  /// rotors give, in air that moves at `wind` [m/s].
  void advance(Xy thrust_mps2, Xy wind_mps);

  /// Lands where it is.
  void stand() { velocity_ = {}; }

  Xy position_m() const { return position_; }
  Xy velocity_mps() const { return velocity_; }

  /// What moving air did to it in the last period [m/s2]: an inertial sensor tells it from thrust.
  Xy drag_mps2() const { return drag_; }

 private:
  Xy position_, velocity_, drag_;
  double thrust_limit_;
};

/// Acceleration per speed through the air [1/s]: linear drag of a loaded multirotor.
inline constexpr double drag_per_s = 0.25;

/// Speed over ground [m/s] that it makes on a straight ferry against a steady `head_wind`; tail
/// wind, below 0, is no gain. Not above 0 where it would be blown away.
double headway_mps(const Vehicle& vehicle, double head_wind_mps);

/// The strongest steady wind [m/s] in which the aircraft still makes its ferry speed in every
/// direction with half of its acceleration limit in hand.
double workable_wind_mps(const Vehicle& vehicle);

}  // namespace furrow::agents
