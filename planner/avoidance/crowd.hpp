#pragma once
// The ways past the obstacles of one pass: which belong together, and what can be done about each
// crowd.

#include "planner/avoidance/curve.hpp"
#include "planner/avoidance/detour.hpp"
#include "planner/avoidance/room.hpp"

#include <vector>

namespace furrow::planner {

/// A straight stretch to spray.
struct PassM {
  PointM a, b;
  double width_m;
  double length_m() const { return norm(b - a); }
};

/// What a pass must go around, on one side of all its circles: an obstacle circle, or the corners
/// of a barrier and where its edges cross the line, each as wide as its clearance.
struct TargetM {
  std::vector<CircleM> circles;
};

/// The circles and barriers of `room` that the pass enters, from its beginning to its end.
std::vector<TargetM> targets_of(const PassM& pass, const Room& room);

/// How a crowd is met.
enum class Conduct {
  sprayed,  ///< Flown around with the valve open.
  closed,   ///< Flown around with the valve closed: the pass is split, and joined by its detour.
  blocked,  ///< Not flown around: the pass ends before and begins anew behind it.
};

/// One choice for one crowd.
struct CrowdOption {
  Conduct conduct;
  std::vector<Side> sides;  ///< One per target; empty where blocked.
  double low_m, high_m;     ///< Along the pass: where it leaves the line and is back.
  CurveM curve;             ///< Around it, in the field frame; without bends where blocked.
  double extra_m;           ///< Longer than the line; 0 where blocked.
};

/// Targets whose detours would meet.
struct Crowd {
  std::vector<std::size_t> targets;
  std::vector<CrowdOption> options;  ///< At least one.
};

/// Angle between the legs that stand for an arc when it is flown; small enough for arcs inscribed
/// in the corners to be the curve again.
constexpr double corner_rad = 0.35;

/// The crowds of a pass in the order flown, each with its eight shortest flyable choices of sides:
/// of up to 6 targets out of all, of more out of those that change sides at most once. Obstacles
/// beside the line that a detour would enter are passed on the side of their neighbours. A crowd
/// that leaves no room for a detour, for instance near an end of the pass, gets the option
/// `blocked`.
///
/// @param turn_m  R_z > 0.
std::vector<Crowd> crowds_of(const PassM& pass, const std::vector<TargetM>& targets,
                             const Room& room, double turn_m);

}  // namespace furrow::planner
