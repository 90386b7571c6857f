#include "app/results/land.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::app {
namespace {

constexpr Length on_edge = metres(1e-6);  // a way along the boundary is not outside

// Shares of the way at which it crosses an edge, with both ends, rising.
std::vector<double> crossings(const Ring& ring, double ax, double ay, double bx, double by) {
  std::vector<double> shares{0.0, 1.0};
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const double px = ring[j].x.base(), py = ring[j].y.base();
    const double ex = ring[i].x.base() - px, ey = ring[i].y.base() - py;
    const double cross = (bx - ax) * ey - (by - ay) * ex;
    if (cross == 0.0) continue;
    const double t = ((px - ax) * ey - (py - ay) * ex) / cross;
    const double u = ((px - ax) * (by - ay) - (py - ay) * (bx - ax)) / cross;
    if (t > 0 && t < 1 && u >= 0 && u <= 1) shares.push_back(t);
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

}  // namespace

Area area(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    twice += ring[j].x.base() * ring[i].y.base() - ring[i].x.base() * ring[j].y.base();
  }
  return square_metres(std::abs(twice) / 2);
}

Area area(const Field& field) {
  Area left = area(field.boundary);
  for (const Ring& hole : field.holes) left -= area(hole);
  return left;
}

bool contains(const Field& field, FieldPoint p) {
  return furrow::contains(field.boundary, p) &&
         std::none_of(field.holes.begin(), field.holes.end(),
                      [&](const Ring& hole) { return furrow::contains(hole, p); });
}

Length length_outside(const Field& field, FieldPoint a, FieldPoint b) {
  const double ax = a.x.base(), ay = a.y.base(), bx = b.x.base(), by = b.y.base();
  const double length_m = std::hypot(bx - ax, by - ay);
  if (length_m == 0) return {};
  const std::vector<double> shares = crossings(field.boundary, ax, ay, bx, by);
  double outside_m = 0;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const double middle = (shares[i - 1] + shares[i]) / 2;
    const FieldPoint place = at_m(ax + middle * (bx - ax), ay + middle * (by - ay));
    if (furrow::contains(field.boundary, place)) continue;
    if (edge_distance(field.boundary, place) <= on_edge) continue;
    outside_m += (shares[i] - shares[i - 1]) * length_m;
  }
  return metres(outside_m);
}

}  // namespace furrow::app
