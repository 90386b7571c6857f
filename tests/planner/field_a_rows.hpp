#pragma once
// Rows on a field with one slanted side, sprayed from end to end: a case whose optimum is known
// from both sides.

#include "planner/coverage/route.hpp"
#include "planner/returns/problem.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace furrow::planner::field_a_rows {

/// (0, 0) (700, 0) (700, 100) (40, 100) (0, 60) m, rows along x at y = 1, 3, ..., 99 m, to and fro
/// from the south-western corner, straight hops between them.
inline Route route(Length cell) {
  std::vector<Strip> strips;
  for (int row = 0; row < 50; ++row) {
    const double y_m = 2.0 * row + 1.0;
    FieldPoint begin = at_m(std::max(0.0, y_m - 60.0), y_m), end = at_m(700.0, y_m);
    if (row % 2 == 1) std::swap(begin, end);
    strips.push_back(end_strip({0, 1}, begin, end, {}));
  }
  return end_to_end_route(cell, std::move(strips));
}

/// Supply at (0, 0), 5 m/s, a tank for 2222 m, packs that last, no time in the bay.
inline ReturnProblem problem(const Route& route) {
  const Vehicle vehicle{.id = AgentId{1},
                        .home = at_m(0, 0),
                        .swath = metres(2),
                        .spray_speed = metres_per_second(5),
                        .ferry_speed = metres_per_second(5),
                        .spray_endurance = seconds(2222.0 / 5.0),
                        .flight_endurance = seconds(1e6),
                        .battery_reserve = 0.0,
                        .tank = litres(10),
                        .min_turn_radius = metres(0),
                        .acceleration_limit = metres_per_second2(3),
                        .gnss = {}};
  const Station station{.id = StationId{1},
                        .position = at_m(0, 0),
                        .bays = 1,
                        .battery_swap = {},
                        .fill_base = {},
                        .fill_full = {}};
  const auto cells = static_cast<std::uint32_t>(route.centers.size());
  return return_problem(route, {0, cells}, vehicle, station);
}

/// All metres flown by a plan: first way out, strips, connections, round trips, last way home.
inline double flown_m(const ReturnPlan& plan) {
  double sum_s = 0.0;
  for (const PlannedSortie& s : plan.sorties) sum_s += s.fly_out_s + s.spray_s + s.fly_back_s;
  return 5.0 * sum_s;
}

}  // namespace furrow::planner::field_a_rows
