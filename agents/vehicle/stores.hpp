#pragma once

#include "core/vehicle.hpp"

namespace furrow::agents {

/// What an aircraft uses up. Nozzles are rate-controlled: the flow follows the speed along the
/// track, so the tank lasts for a distance; the pack lasts for a time in the air. What was used
/// beyond them stays as a debt, for the laws of a run to see.
struct Stores {
  double tank_share = 1.0;
  double pack_share = 1.0;

  void spray(const Vehicle& v, double along_m) { tank_share -= along_m / tank_range(v).base(); }
  /// @param time_s  Of level flight; a climb counts as the level flight that takes as much.
  void fly(const Vehicle& v, double time_s) { pack_share -= time_s / v.flight_endurance.base(); }

  /// Distance the tank still sprays [m].
  double spray_left_m(const Vehicle& v) const { return tank_share * tank_range(v).base(); }
  /// Time the pack still flies before its reserve [s]; negative below it.
  double flight_left_s(const Vehicle& v) const {
    return (pack_share - v.battery_reserve) * v.flight_endurance.base();
  }
};

}  // namespace furrow::agents
