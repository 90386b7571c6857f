#include "planner/returns/problem.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::planner {

ReturnProblem return_problem(const Route& route, CellRange cells, const Vehicle& vehicle,
                             const Station& station) {
  require(cells.count > 0 && end(cells) <= route.centers.size(),
          "a share is not empty and lies within the route");
  ReturnProblem problem{.vehicle = vehicle,
                        .station = station,
                        .cells = cells,
                        .spray_m = {},
                        .on_route_s = {},
                        .home_m = {},
                        .fly_out_m = distance(vehicle.home, route.centers[cells.first]).base(),
                        .strip_starts = {0}};
  const auto next_strip = [&](std::uint32_t cell) {
    return std::upper_bound(route.strips.begin(), route.strips.end(), cell,
                            [](std::uint32_t c, const Strip& s) { return c < s.cells.first; });
  };
  // Metres and seconds from here on. Moves are counted, so that sums do not drift.
  const double cell_m = route.cell.base();
  double moves = 0.0, jumps_s = 0.0;
  auto strip = next_strip(cells.first);
  for (std::uint32_t i = 0; i < cells.count; ++i) {
    const std::uint32_t cell = cells.first + i;
    const bool begins = strip != route.strips.end() && strip->cells.first == cell;
    if (i > 0 && begins) problem.strip_starts.push_back(i);
    if (i > 0 && begins && !strip->continues) {
      jumps_s += distance(route.centers[cell - 1], route.centers[cell]).base() /
                 vehicle.ferry_speed.base();
    } else if (i > 0) {
      moves += 1.0;
    }
    if (begins) ++strip;
    problem.spray_m.push_back(moves * cell_m);
    problem.on_route_s.push_back(moves * cell_m / vehicle.spray_speed.base() + jumps_s);
    problem.home_m.push_back(distance(route.centers[cell], station.position).base());
  }
  return problem;
}

}  // namespace furrow::planner
