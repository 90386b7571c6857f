#pragma once
// Curves of lines and arcs, in raw metres: what a turn, a detour and a Dubins path all are.

#include "planner/coverage/plane.hpp"

#include <vector>

namespace furrow::planner {

/// A place and the way the aircraft looks there.
struct PoseM {
  PointM at;
  double heading_rad;  ///< Counter-clockwise from +x.
};

/// A stretch of constant curvature.
struct Bend {
  double curvature_per_m;  ///< Left turns positive; 0 on a straight line.
  double length_m;         ///< >= 0.
};

/// A curve without corners.
struct CurveM {
  PoseM start{};
  std::vector<Bend> bends{};
};

/// `angle_rad` less whole turns, in (-pi, pi].
double wrapped_rad(double angle_rad);

/// The pose after `length_m` of one bend.
PoseM advanced(PoseM from, Bend bend);

PoseM end_pose(const CurveM& curve);
double length_m(const CurveM& curve);

/// Places on the curve from its start to its end, no two further apart along it than `step_m` > 0.
PathM sampled(const CurveM& curve, double step_m);

/// Corners of tangents around the curve, from its start to its end, none sharper than `turn_rad`
/// in (0, pi). It nowhere cuts an arc short, and arcs inscribed in its corners, half a leg to each
/// side, are the curve again.
PathM tangent_path(const CurveM& curve, double turn_rad);

}  // namespace furrow::planner
