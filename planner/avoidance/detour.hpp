#pragma once
// One obstacle and one line: the circles and formulas of a detour.

#include "core/geometry.hpp"

#include <span>
#include <vector>

namespace furrow::planner {

/// On which side of an obstacle an aircraft passes, seen in the direction of flight.
enum class Side { left, right };

constexpr double sign(Side side) { return side == Side::left ? 1.0 : -1.0; }
constexpr Side opposite(Side side) { return side == Side::left ? Side::right : Side::left; }

/// Ground not to be flown over.
struct Circle {
  FieldPoint center;
  Length radius;
};

/// The circle to keep out of: R_i = R_d + R_l.
constexpr Circle obstacle_circle(FieldPoint center, Length obstacle, Length safety) {
  return {center, obstacle + safety};
}

/// Whether the straight way from `from` to `to` enters `circle`: only then is it a target.
bool crosses(FieldPoint from, FieldPoint to, const Circle& circle);

/// An obstacle seen from its line: how far its centre lies beside it, and its radius.
struct Beside {
  Length left;    ///< Of the centre, left of the line positive.
  Length radius;  ///< > 0.
};

/// The circle to fly around on `side`: the same, or where it is tighter than the turn radius the
/// circle of that radius that contains it and touches it from inside on that side.
Beside replaced(Beside obstacle, Length turn_radius, Side side);

/// A detour of three arcs: off the line on a turn circle, around the obstacle, back on another.
struct DetourShape {
  Length reach;     ///< dx: how far before and after the circle's centre it leaves the line.
  double turn_rad;  ///< theta: through which either turn circle is followed.
  Length extra;     ///< 2 (R_z + R) theta - 2 dx: longer than the line.
};

/// The detour around a target on `side`:
///
///     dx = sqrt((R_z + R)^2 - (R_z -+ L_d)^2),  theta = arccos((R_z -+ L_d) / (R_z + R))
///
/// with - where the circle's centre lies on the side that is passed, R and L_d those of the
/// replaced circle.
///
/// @param turn_radius  R_z > 0.
/// @pre  The line crosses the circle.
/// Source: Zhang et al. 2017, Northeast Agricultural University; formulas derived anew.
DetourShape detour_shape(Beside target, Length turn_radius, Side side);

/// Length of a pass of length `straight` with separate detours: L = b + sum of extras.
Length pass_length(Length straight, std::span<const DetourShape> detours);

}  // namespace furrow::planner
