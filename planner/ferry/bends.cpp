#include "planner/ferry/bends.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

constexpr double straight_rad = 1e-6;
constexpr double spare = 1.1;  // the angle of a moved bend differs a little
constexpr double tight_m = 0.05;

PointM unit(PointM p) { return (1 / norm(p)) * p; }

}  // namespace

PathM clear_of_corners(const PathM& path, const EdgeGrid& edges, double cut_m) {
  if (cut_m <= 0 || path.size() < 3) return path;
  PathM made{path.front()};
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const PointM before = made.back(), bend = path[i], after = path[i + 1];
    const PointM in = bend - before, out = after - bend;
    if (norm(in) == 0 || norm(out) == 0) continue;
    const double turn = std::abs(std::atan2(cross(in, out), dot(in, out)));
    if (turn < straight_rad) {
      made.push_back(bend);
      continue;
    }
    const PointM outwards = unit(unit(in) - unit(out));
    const double cut = std::min({cut_m, norm(in) / 2, norm(out) / 2});
    const PointM moved = bend + spare * cut * std::tan(turn / 4) * outwards;
    if (edges.sees(before, moved) && edges.sees(moved, after)) {
      made.push_back(moved);
    } else {
      const double near_m = std::min({tight_m, norm(in) / 3, norm(out) / 3});
      made.insert(made.end(), {bend - near_m * unit(in), bend, bend + near_m * unit(out)});
    }
  }
  made.push_back(path.back());
  return made;
}

}  // namespace furrow::planner
