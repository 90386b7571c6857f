#pragma once

#include "core/geometry.hpp"
#include "planner/avoidance/curve.hpp"

namespace furrow::planner {

/// A place in the field and the way the aircraft looks there.
struct Pose {
  FieldPoint at;
  double heading_rad;  ///< Counter-clockwise from east.
};

/// The shortest curve between two poses that is nowhere tighter than `radius` > 0.
/// @return  Three bends; in metres of the field frame.
/// Source: Dubins 1957, Am. J. Math. 79, 497-516, as OMPL finds it.
CurveM dubins_curve(Pose from, Pose to, Length radius);

}  // namespace furrow::planner
