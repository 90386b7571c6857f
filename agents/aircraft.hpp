#pragma once

#include "agents/gnss/receiver.hpp"
#include "agents/guidance/pilot.hpp"
#include "agents/guidance/position_filter.hpp"
#include "agents/settings.hpp"
#include "agents/vehicle/airframe.hpp"
#include "agents/vehicle/breeze.hpp"
#include "agents/vehicle/stores.hpp"

#include <optional>
#include <string>

namespace furrow::agents {

/// The same as a plain number, for the control loop [m/s2].
inline double planned_acceleration_mps2(const Vehicle& vehicle) {
  return planned_acceleration(vehicle).base();
}

/// Why an autopilot that senses and acts ten times a second cannot hold a vehicle on its line, or
/// nothing when it can. Bounds found by flying strips of any swath at any speed and acceleration:
///
/// - In one control period it flies half a swath at most at spray speed, for the valve opens and
///   closes no finer, and a swath at ferry speed, by which its place is uncertain.
/// - It can accelerate by more than the noise of its measured velocity calls for.
/// - The arc of a corner between strips takes five control periods.
std::optional<std::string> unholdable(const Vehicle& vehicle);

/// A simulated aircraft with its sensors and its autopilot, without any purpose of its own.
class Aircraft {
 public:
  explicit Aircraft(const AgentSettings& settings);

  /// Leaves the ground where it stands; hovers until it has a path.
  void take_off();
  void land();

  void follow(Path path) { pilot_.follow(std::move(path)); }

  /// As Pilot::leads_on and Pilot::redirect.
  bool leads_on(const Path& path) const { return pilot_.leads_on(path); }
  void redirect(Path path) { pilot_.redirect(std::move(path)); }

  /// One control period in the air, to stop at `stop_m` along the path at the latest.
  void fly(double stop_m);

  /// One control period towards a height, as fast as `rule` lets it climb or descend, with a fifth
  /// in hand against gusts. Takes what climbing takes from the pack.
  /// @return  That, in seconds of level flight.
  double climb_to(double altitude_m, const planner::HeightRule& rule);

  /// Is at a height at once: where it takes off.
  void start_at(double altitude_m) { altitude_m_ = altitude_m; }

  /// Above the datum; 0 over level land.
  double altitude_m() const { return altitude_m_; }

  /// How far along its path it takes itself to be [m].
  double along_m() const { return pilot_.deviation_now().along_m; }
  /// Whether it hovers at `stop_m` or at the end of its path.
  bool is_at_rest(double stop_m) const;

  const Pilot& pilot() const { return pilot_; }
  Xy truth_m() const { return airframe_.position_m(); }
  Xy velocity_mps() const { return airframe_.velocity_mps(); }
  Xy estimate_m() const { return filter_.estimate_m(); }
  Xy fix_m() const { return fix_; }

  Stores stores;

 private:
  Vehicle vehicle_;
  Airframe airframe_;
  Breeze breeze_;
  Receiver receiver_;
  PositionFilter filter_;
  Pilot pilot_;
  Xy fix_;
  Xy wind_estimate_;
  double altitude_m_ = 0.0;
};

}  // namespace furrow::agents
