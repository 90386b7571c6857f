#include "planner/fleet/path_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow::planner::fleet {

PathCells::PathCells(const StripPath& path, double cell_m) {
  const auto most =
      static_cast<std::size_t>(path.length_m() / cell_m) + 2 * std::size_t{path.strips()} + 1;
  ends_m_.reserve(most + 1);
  strips_.reserve(most);
  ends_m_.push_back(0.0);
  for (std::uint32_t s = 0; s < path.strips(); ++s) {
    const double begin_m = path.begin_m(s), length_m = path.begin_m(s + 1) - begin_m;
    const double pieces = std::ceil(length_m / cell_m);
    for (double k = 1.0; k < pieces; ++k) ends_m_.push_back(begin_m + length_m * (k / pieces));
    ends_m_.push_back(path.begin_m(s + 1));
    strips_.resize(ends_m_.size() - 1, s);
  }
}

std::vector<FieldPoint> places_to_leave(const FleetProblem& problem) {
  std::vector<std::pair<double, double>> all;
  all.reserve(problem.depots.size() + problem.fliers.size());
  const auto add = [&](FieldPoint p) { all.emplace_back(p.x.base(), p.y.base()); };
  for (const Depot& d : problem.depots) add(d.position);
  for (const Flier& f : problem.fliers) add(f.start);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::vector<FieldPoint> places;
  places.reserve(all.size());
  for (const auto& [x_m, y_m] : all) places.push_back(at_m(x_m, y_m));
  return places;
}

}  // namespace furrow::planner::fleet
