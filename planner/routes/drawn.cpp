#include "planner/routes/drawn.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

// Off the straight line from `a` to `b`.
double distance_m(WayPoint p, WayPoint a, WayPoint b) {
  const double x = b.x_m - a.x_m, y = b.y_m - a.y_m, z = b.z_m - a.z_m;
  const double along = (p.x_m - a.x_m) * x + (p.y_m - a.y_m) * y + (p.z_m - a.z_m) * z;
  const double squares = x * x + y * y + z * z;
  const double t = squares > 0 ? std::clamp(along / squares, 0.0, 1.0) : 0.0;
  return planner::distance_m(p, between(a, b, t));
}

void keep(std::span<const WayPoint> line, double off_m, std::vector<WayPoint>& kept) {
  std::size_t furthest = 0;
  double most_m = off_m;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const double here_m = distance_m(line[i], line.front(), line.back());
    if (here_m <= most_m) continue;
    most_m = here_m;
    furthest = i;
  }
  if (furthest == 0) return;
  keep(line.first(furthest + 1), off_m, kept);
  kept.push_back(line[furthest]);
  keep(line.subspan(furthest), off_m, kept);
}

}  // namespace

std::vector<WayPoint> drawn(std::span<const WayPoint> line, double off_m) {
  std::vector<WayPoint> kept;
  keep(line, off_m, kept);
  return kept;
}

}  // namespace furrow::planner
