#pragma once
// How an aircraft turns where two straight legs meet: flown so by the agents, timed so by the
// scheduler.

#include "core/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace furrow {

/// What a corner allows.
enum class Corner : std::uint8_t {
  cut,   ///< An arc that leaves both legs as far from the corner as the aircraft likes.
  held,  ///< An arc that passes the corner within `corner_room_m`: where an edge is near.
  stop,  ///< Turned at a stop: where the valve opens or closes at the very end of a strip.
};

/// The furthest that the arc of a held corner passes from it.
inline constexpr double corner_room_m = 0.1;
/// Held corners sharper than this are turned at a stop: no autopilot of 10 Hz holds their arcs.
inline constexpr double sharpest_held_rad = 0.5;
/// Turns below this are none.
inline constexpr double straight_rad = 1e-6;

/// An arc that leaves one leg `cut_m` before the corner and joins the next as far behind it; both 0
/// where the corner is turned at a stop.
struct CornerArc {
  double cut_m, radius_m;
};

/// The arc of a corner.
///
/// An arc of radius r around a turn by the angle q leaves the legs r tan(q / 2) from the corner and
/// passes it at a distance of cut tan(q / 4).
///
/// @param angle_rad      straight_rad < angle <= pi.
/// @param leg_m          The shorter of both legs; an arc takes at most half of it.
/// @param cut_m          The most that an arc takes of a leg.
/// @param least_radius_m No arc is tighter; a corner that would be is turned at a stop.
inline CornerArc corner_arc(Corner corner, double angle_rad, double leg_m, double cut_m,
                            double least_radius_m) {
  constexpr double tightest_m = 0.01;  // below it an aircraft might as well stop and turn
  if (corner == Corner::stop) return {0.0, 0.0};
  double cut = std::min(cut_m, 0.5 * leg_m);
  if (corner == Corner::held) {
    if (angle_rad > sharpest_held_rad) return {0.0, 0.0};
    cut = std::min(cut, corner_room_m / std::tan(0.25 * angle_rad));
  }
  const double radius = cut / std::tan(0.5 * angle_rad);
  if (radius < std::max(tightest_m, least_radius_m)) return {0.0, 0.0};
  return {cut, radius};
}

/// How far a way turns between two legs, to either side [rad].
inline double turn_rad(FieldVector in, FieldVector out) {
  const double along = (in.x * out.x + in.y * out.y).base();
  const double across = (in.x * out.y - in.y * out.x).base();
  return std::abs(std::atan2(across, along));
}

/// Of the acceleration, across in arcs; the rest keeps aircraft on them.
inline constexpr double turning_share = 0.9;

/// At which an arc takes that share.
inline double arc_speed_mps(double acceleration_mps2, double radius_m) {
  return std::sqrt(turning_share * acceleration_mps2 * radius_m);
}

/// How long a leg takes between two speeds, by its trapezoid [s].
/// @param limit_mps  Fastest on it, unless it begins or ends faster.
inline double leg_time_s(double length_m, double limit_mps, double from_mps, double to_mps,
                         double acceleration_mps2) {
  if (length_m <= 0.0) return 0.0;
  const double squares = from_mps * from_mps + to_mps * to_mps;
  const double reached_mps = std::sqrt(acceleration_mps2 * length_m + 0.5 * squares);
  const double peak_mps = std::max({std::min(reached_mps, limit_mps), from_mps, to_mps});
  const double ramps_m = (2.0 * peak_mps * peak_mps - squares) / (2.0 * acceleration_mps2);
  return (2.0 * peak_mps - from_mps - to_mps) / acceleration_mps2 +
         std::max(0.0, length_m - ramps_m) / peak_mps;
}

}  // namespace furrow
