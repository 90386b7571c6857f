#pragma once

#include "core/geometry.hpp"
#include "core/ids.hpp"
#include "core/window.hpp"

#include <optional>

namespace furrow {

/// How far a position fix may be from the truth.
struct Gnss {
  Length sigma;  ///< Standard deviation of each axis of a fix, white.
  Length bias;   ///< Constant offset of every fix of one aircraft, in a direction drawn once.
};

/// What a plant-protection UAV can do. All limits > 0 unless said.
struct Vehicle {
  AgentId id;
  FieldPoint home;  ///< Where it stands, full and charged, when the mission starts.
  Length swath;     ///< Width sprayed in one pass.
  Speed spray_speed;
  Speed ferry_speed;
  Seconds spray_endurance;   ///< Spraying time of a full tank at spray speed.
  Seconds flight_endurance;  ///< Flying time of a full battery pack.
  double battery_reserve;    ///< Share of a pack that is never planned with, 0 <= r < 1.
  Volume tank;
  Length min_turn_radius;  ///< 0 for an aircraft that can turn on the spot.
  Acceleration acceleration_limit;
  Gnss gnss;
  Seconds available_from{};  ///< Mission time of its first take-off at the earliest.
  std::optional<Seconds> available_until{};  ///< It is down for good by then; none: no end.
};

/// The furthest spraying distance of one tank, D_max.
/// Source: Wang et al. 2017, section 2.2.
constexpr Length tank_range(const Vehicle& v) { return v.spray_endurance * v.spray_speed; }

/// Mix sprayed on each area unit: a tank spread over its range times the swath.
constexpr ApplicationRate application_rate(const Vehicle& v) {
  return v.tank / (tank_range(v) * v.swath);
}

/// Acceleration that flights are planned with; the rest of the limit is left to corrections.
constexpr Acceleration planned_acceleration(const Vehicle& v) {
  return 0.95 * v.acceleration_limit;
}

/// When plans have it down for good at the latest; none: no end.
constexpr std::optional<Seconds> planned_until(const Vehicle& v) {
  return planned_end(v.available_from, v.available_until);
}

/// Flying time a plan may use from one full pack.
constexpr Seconds usable_endurance(const Vehicle& v) {
  return (1.0 - v.battery_reserve) * v.flight_endurance;
}

/// Flying time that a pack has to be good for, reserve kept, before a flight that is foreseen to
/// take `flight_s` seconds is begun on it: gusts and corrections take some besides.
constexpr double wanted_pack_s(double flight_s) { return 1.005 * flight_s + 6.0; }

/// The longest flight in seconds that a full pack is good for, its gusts and corrections included.
constexpr double longest_flight_s(const Vehicle& v) {
  return (usable_endurance(v).base() - wanted_pack_s(0.0)) /
         (wanted_pack_s(1.0) - wanted_pack_s(0.0));
}

}  // namespace furrow
