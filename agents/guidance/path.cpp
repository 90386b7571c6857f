#include "agents/guidance/path.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::agents {
namespace {

constexpr double shortest_leg_m = 1e-6;

}  // namespace

Path::Path(Xy start_m, PathLimits limits) : limits_{limits} {
  vertices_.push_back({.at = start_m, .leg_m = 0.0, .limit_mps = 0.0});
}

double Path::add(Xy to_m, double limit_mps, Corner corner) {
  const double leg = norm(to_m - vertices_.back().at);
  if (leg < shortest_leg_m) {
    vertices_.back().corner = std::max(vertices_.back().corner, corner);
    return vertices_.back().leg_m;
  }
  vertices_.push_back({.at = to_m,
                       .leg_m = vertices_.back().leg_m + leg,
                       .limit_mps = limit_mps,
                       .corner = corner});
  return vertices_.back().leg_m;
}

void Path::finish() {
  require(segments_.empty(), "a path is finished once");
  cut_corners();
  plan_speeds();
}

// The angle by which the path turns at an inner vertex, right positive.
double Path::turn(std::size_t corner) const {
  const Xy in = vertices_[corner].at - vertices_[corner - 1].at;
  const Xy out = vertices_[corner + 1].at - vertices_[corner].at;
  return std::atan2(dot(right_of(in), out), dot(in, out));
}

void Path::append(const Segment& segment) {
  segments_.push_back(segment);
  length_ += segment.length_m;
}

void Path::cut_corners() {
  if (vertices_.size() == 1) {  // nowhere to go: one segment of no length
    append({0.0, 0.0, vertices_[0].at, {0.0, 1.0}, 0.0, 0.0, 0.0});
    return;
  }
  for (std::size_t i = 1; i < vertices_.size(); ++i) {
    Vertex& vertex = vertices_[i];
    const Vertex& before = vertices_[i - 1];
    const double leg = vertex.leg_m - before.leg_m;
    const Xy ahead = (1.0 / leg) * (vertex.at - before.at);
    const bool is_last = i + 1 == vertices_.size();
    const double angle = is_last ? 0.0 : turn(i);

    double radius = 0.0;
    if (std::abs(angle) > straight_rad) {
      const double next_leg = vertices_[i + 1].leg_m - vertex.leg_m;
      const CornerArc arc = corner_arc(vertex.corner, std::abs(angle), std::min(leg, next_leg),
                                       limits_.corner_cut_m, limits_.min_radius_m);
      vertex.cut_m = arc.cut_m;
      radius = arc.radius_m;
    }
    const double straight = std::max(0.0, leg - before.cut_m - vertex.cut_m);
    append({length_, straight, before.at + before.cut_m * ahead, ahead, 0.0, vertex.limit_mps,
            vertex.limit_mps});
    vertex.arc_start_m = length_;
    if (radius > 0.0) {
      const double limit = std::min({vertex.limit_mps, vertices_[i + 1].limit_mps,
                                     arc_speed_mps(limits_.acceleration_mps2, radius)});
      vertex.arc_length_m = radius * std::abs(angle);
      append({length_, vertex.arc_length_m, vertex.at - vertex.cut_m * ahead, ahead,
              std::copysign(1.0 / radius, angle), limit, limit});
    } else if (std::abs(angle) > straight_rad) {
      segments_.push_back({length_, 0.0, vertex.at, ahead, 0.0, 0.0, 0.0});  // stop and turn
    }
  }
}

void Path::plan_speeds() {
  const double a2 = 2.0 * limits_.acceleration_mps2;
  double exit = 0.0;
  for (std::size_t i = segments_.size(); i-- > 0;) {
    Segment& s = segments_[i];
    s.entry_mps = std::min(s.limit_mps, std::sqrt(exit * exit + a2 * s.length_m));
    if (i > 0) s.entry_mps = std::min(s.entry_mps, segments_[i - 1].limit_mps);
    exit = s.entry_mps;
  }
}

double Path::along_m(double leg_m) const {
  const auto next = std::find_if(vertices_.begin(), vertices_.end(),
                                 [&](const Vertex& v) { return leg_m <= v.leg_m + v.cut_m; });
  if (next == vertices_.end()) return length_;
  if (next == vertices_.begin()) return 0.0;
  const double into_arc = leg_m - (next->leg_m - next->cut_m);
  if (into_arc <= 0.0 || next->cut_m == 0.0) return next->arc_start_m + into_arc;
  return next->arc_start_m + next->arc_length_m * into_arc / (2.0 * next->cut_m);
}

double Path::duration_s() const {
  double total = 0.0, entry = 0.0;
  const double a = limits_.acceleration_mps2;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Segment& s = segments_[i];
    const double planned = i + 1 < segments_.size() ? segments_[i + 1].entry_mps : 0.0;
    const double exit = std::min(planned, std::sqrt(entry * entry + 2.0 * a * s.length_m));
    total += leg_time_s(s.length_m, s.limit_mps, entry, exit, a);
    entry = exit;
  }
  return total;
}

Pose pose(const Segment& s, double along_m) {
  const double q = along_m - s.start_m;
  if (s.is_straight()) return {s.from + q * s.ahead, s.ahead};
  const Xy right = right_of(s.ahead);
  const double angle = s.curvature_per_m * q;
  const double sine = std::sin(angle), cosine = std::cos(angle);
  return {
      s.from + (sine / s.curvature_per_m) * s.ahead + ((1.0 - cosine) / s.curvature_per_m) * right,
      cosine * s.ahead + sine * right};
}

}  // namespace furrow::agents
