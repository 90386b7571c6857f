#pragma once
// Several circles and one line: the shortest way past all of them on given sides.

#include "planner/avoidance/curve.hpp"
#include "planner/avoidance/detour.hpp"

#include <optional>
#include <vector>

namespace furrow::planner {

/// A circle beside a line that runs along +x through the origin, and the side to pass it on. In
/// metres, at least as wide as the turn radius.
struct PassedCircle {
  PointM center;
  double radius_m;
  Side side;
};

/// Where the detour around one circle alone leaves the line and comes back. Empty (low > high)
/// where the line itself passes the circle on that side.
struct AlongLine {
  double low_m, high_m;
};
AlongLine detour_span(const PassedCircle& circle, double turn_m);

/// A string pulled tight past `circles`: off the line on a turn circle, along arcs and common
/// tangents, back on another turn circle. Circles that the string need not touch are left out, so
/// a crowd is passed along its hull; one circle alone gives its detour of three arcs.
///
/// @return  Nothing where circles to be passed on different sides leave no way between, or no
///          detour is needed. Whether the way enters a circle is not checked here.
std::optional<CurveM> taut_curve(std::vector<PassedCircle> circles, double turn_m);

}  // namespace furrow::planner
