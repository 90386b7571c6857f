#pragma once
// Plane geometry in raw metres for the hot loops of coverage. Public doors speak in
// FieldPoint and Length; models convert once each way.

#include <algorithm>
#include <cmath>
#include <vector>

namespace furrow::planner {

/// A place or a displacement, in metres, in a frame that the user of it names.
struct PointM {
  double x, y;
  friend constexpr PointM operator+(PointM a, PointM b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr PointM operator-(PointM a, PointM b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr PointM operator*(double k, PointM a) { return {k * a.x, k * a.y}; }
  friend constexpr bool operator==(PointM, PointM) = default;
};

constexpr double cross(PointM a, PointM b) { return a.x * b.y - a.y * b.x; }
constexpr double dot(PointM a, PointM b) { return a.x * b.x + a.y * b.y; }
inline double norm(PointM a) { return std::sqrt(dot(a, a)); }

/// The place of the straight line from `a` to `b` that is nearest to `p`.
inline PointM nearest_on(PointM p, PointM a, PointM b) {
  const PointM along = b - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return a + t * along;
}

/// From `p` to the nearest place of the line from `a` to `b`.
inline double distance_m(PointM p, PointM a, PointM b) { return norm(p - nearest_on(p, a, b)); }

/// Whether the lines from `a` to `b` and from `c` to `d` cross, ends left out.
constexpr bool cross_each_other(PointM a, PointM b, PointM c, PointM d) {
  const auto side = [](PointM p, PointM q, PointM r) { return cross(q - p, r - p); };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Between the lines from `a` to `b` and from `c` to `d`; 0 where they cross.
inline double apart_m(PointM a, PointM b, PointM c, PointM d) {
  if (cross_each_other(a, b, c, d)) return 0;
  return std::min(
      {distance_m(a, c, d), distance_m(b, c, d), distance_m(c, a, b), distance_m(d, a, b)});
}

using RingM = std::vector<PointM>;
using PathM = std::vector<PointM>;

/// One connected piece of land: what `outer` encloses and no hole does. `outer` runs
/// counter-clockwise and holes clockwise, so that land is always on the left of an edge.
struct LandPart {
  RingM outer;
  std::vector<RingM> holes;
};
using LandParts = std::vector<LandPart>;

/// Twice-signed shoelace halved: positive for a counter-clockwise ring, in m2.
inline double signed_area_m2(const RingM& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    twice += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  }
  return twice / 2;
}

inline double area_m2(const LandPart& part) {
  double sum = signed_area_m2(part.outer);
  for (const RingM& hole : part.holes) sum += signed_area_m2(hole);
  return sum;
}

inline double area_m2(const LandParts& parts) {
  double sum = 0;
  for (const LandPart& part : parts) sum += area_m2(part);
  return sum;
}

inline double length_m(const PathM& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += norm(path[i] - path[i - 1]);
  return sum;
}

/// From corner to corner, along both axes.
struct BoxM {
  PointM low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
};

inline BoxM box_of(const PathM& places) {
  BoxM box;
  for (const PointM p : places) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

constexpr BoxM box_of(PointM a, PointM b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// Further out by `by_m` on all sides.
constexpr BoxM grown(const BoxM& box, double by_m) {
  return {box.low - PointM{by_m, by_m}, box.high + PointM{by_m, by_m}};
}

inline bool overlap(const BoxM& a, const BoxM& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Whether the way from `p` along +x crosses the edge from `a` to `b`. A place is within the rings
/// that it crosses an odd number of times.
constexpr bool is_left_of(PointM p, PointM a, PointM b) {
  return (a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x;
}

/// All of it shifted.
inline LandParts moved(LandParts parts, PointM by) {
  for (LandPart& part : parts) {
    for (PointM& p : part.outer) p = p + by;
    for (RingM& hole : part.holes) {
      for (PointM& p : hole) p = p + by;
    }
  }
  return parts;
}

/// A frame turned so that rows lie along +x of it: `to` maps field to rows, `from` back.
struct RowFrame {
  double cosine, sine;

  static RowFrame along(PointM direction) {
    const double length = norm(direction);
    return {direction.x / length, direction.y / length};
  }
  PointM to(PointM p) const { return {cosine * p.x + sine * p.y, -sine * p.x + cosine * p.y}; }
  PointM from(PointM p) const { return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y}; }
};

/// Calls `use(a, b)` for every edge of `part`, outer ring first, land on the left.
template <class Use>
void each_edge(const LandPart& part, Use use) {
  const auto ring_edges = [&](const RingM& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) use(ring[i], ring[(i + 1) % ring.size()]);
  };
  ring_edges(part.outer);
  for (const RingM& hole : part.holes) ring_edges(hole);
}

}  // namespace furrow::planner
