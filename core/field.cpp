#include "core/field.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace furrow {

bool contains(const Ring& ring, FieldPoint p) {
  const double x = p.x.base(), y = p.y.base();
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const double x1 = ring[j].x.base(), y1 = ring[j].y.base();
    const double x2 = ring[i].x.base(), y2 = ring[i].y.base();
    const bool passes = (y1 > y) != (y2 > y);
    if (passes && x < x1 + (x2 - x1) * (y - y1) / (y2 - y1)) inside = !inside;
  }
  return inside;
}

Length edge_distance(const Ring& ring, FieldPoint p) {
  const double x = p.x.base(), y = p.y.base();
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const double x1 = ring[j].x.base(), y1 = ring[j].y.base();
    const double dx = ring[i].x.base() - x1, dy = ring[i].y.base() - y1;
    const double squared = dx * dx + dy * dy;
    const double share = squared > 0.0 ? ((x - x1) * dx + (y - y1) * dy) / squared : 0.0;
    const double t = std::clamp(share, 0.0, 1.0);
    nearest_m = std::min(nearest_m, std::hypot(x - x1 - t * dx, y - y1 - t * dy));
  }
  return metres(nearest_m);
}

Obstacle outlined(std::string id, Ring outline) {
  FieldPoint low = outline.front(), high = outline.front();
  for (const FieldPoint p : outline) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const FieldPoint center = low + FieldVector{0.5 * (high - low).x, 0.5 * (high - low).y};
  Length radius{};
  for (const FieldPoint p : outline) radius = std::max(radius, distance(center, p));
  return {std::move(id), center, radius, std::move(outline)};
}

Length depth_in(const Obstacle& obstacle, FieldPoint p) {
  if (obstacle.outline.empty()) return obstacle.radius - distance(obstacle.center, p);
  const Length to_edge = edge_distance(obstacle.outline, p);
  return contains(obstacle.outline, p) ? to_edge : -to_edge;
}

}  // namespace furrow
