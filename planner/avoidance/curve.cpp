#include "planner/avoidance/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow::planner {
namespace {

PointM ahead(double heading_rad) { return {std::cos(heading_rad), std::sin(heading_rad)}; }

void append(PathM& path, PointM at) {
  constexpr double same_m = 1e-9;
  if (path.empty() || norm(at - path.back()) > same_m) path.push_back(at);
}

}  // namespace

double wrapped_rad(double angle_rad) {
  const double turn = 2 * std::numbers::pi;
  const double left = std::remainder(angle_rad, turn);
  return left <= -std::numbers::pi ? left + turn : left;
}

PoseM advanced(PoseM from, Bend bend) {
  const double turn = bend.curvature_per_m * bend.length_m;
  // The chord of an arc looks half its turn aside; sinc keeps a nearly straight one exact.
  const double half = turn / 2;
  const double sinc = std::abs(half) < 1e-6 ? 1.0 - half * half / 6 : std::sin(half) / half;
  return {from.at + bend.length_m * sinc * ahead(from.heading_rad + half), from.heading_rad + turn};
}

PoseM end_pose(const CurveM& curve) {
  PoseM at = curve.start;
  for (const Bend& bend : curve.bends) at = advanced(at, bend);
  return at;
}

double length_m(const CurveM& curve) {
  double sum = 0;
  for (const Bend& bend : curve.bends) sum += bend.length_m;
  return sum;
}

PathM sampled(const CurveM& curve, double step_m) {
  PathM path{curve.start.at};
  PoseM at = curve.start;
  for (const Bend& bend : curve.bends) {
    const double steps = bend.curvature_per_m == 0 ? 1 : std::ceil(bend.length_m / step_m);
    for (double i = 1; i <= steps; ++i) {
      append(path, advanced(at, {bend.curvature_per_m, bend.length_m * i / steps}).at);
    }
    at = advanced(at, bend);
  }
  return path;
}

PathM tangent_path(const CurveM& curve, double turn_rad) {
  PathM path{curve.start.at};
  PoseM at = curve.start;
  for (const Bend& bend : curve.bends) {
    const double turn = std::abs(bend.curvature_per_m) * bend.length_m;
    if (turn > 1e-9) {
      const double steps = std::ceil(turn / turn_rad);
      const Bend part{bend.curvature_per_m, bend.length_m / steps};
      const double to_corner_m = std::tan(turn / steps / 2) / std::abs(bend.curvature_per_m);
      PoseM from = at;
      for (double i = 0; i < steps; ++i) {
        append(path, from.at + to_corner_m * ahead(from.heading_rad));
        from = advanced(from, part);
      }
    }
    at = advanced(at, bend);
  }
  append(path, at.at);
  return path;
}

}  // namespace furrow::planner
