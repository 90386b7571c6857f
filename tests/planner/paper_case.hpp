#pragma once
// The examples of Wang et al. 2017 as values, for every test and benchmark that leans on them.

#include "planner/coverage/walk.hpp"
#include "planner/returns/problem.hpp"

namespace furrow::planner::paper_case {

/// 25 min of flight, 15 min of spraying at 3 m/s (D_max = 2700 m), ferries at 6 m/s, swath 2 m.
inline Vehicle vehicle() {
  return {.id = AgentId{1},
          .home = at_m(1, 1),
          .swath = metres(2),
          .spray_speed = metres_per_second(3),
          .ferry_speed = metres_per_second(6),
          .spray_endurance = seconds(900),
          .flight_endurance = seconds(1500),
          .battery_reserve = 0.0,
          .tank = litres(15),
          .min_turn_radius = Length{},
          .acceleration_limit = metres_per_second2(2),
          .gnss = {}};
}

inline Station station() {
  return {.id = StationId{1},
          .position = at_m(0, 0),
          .bays = 1,
          .battery_swap = seconds(60),
          .fill_base = seconds(20),
          .fill_full = seconds(60)};
}

/// A rectangle with its south-western corner at the datum, less the right isosceles triangle with
/// legs of `cut_m` in its north-western corner.
inline Field field(double wide_m, double long_m, double cut_m = 0.0) {
  Field f{.boundary = {at_m(0, 0), at_m(wide_m, 0), at_m(wide_m, long_m)},
          .holes = {},
          .obstacles = {}};
  if (cut_m > 0.0) {
    f.boundary.push_back(at_m(cut_m, long_m));
    f.boundary.push_back(at_m(0, long_m - cut_m));
  } else {
    f.boundary.push_back(at_m(0, long_m));
  }
  return f;
}

inline Field field_a() { return field(100, 700, 40); }
inline Field field_b() { return field(100, 400); }

/// From (1, 1) along +y, strips advancing along +x.
inline Route route(const Field& f) {
  return *coverage_route(f, metres(2), CoverageSettings{.start = at_m(1, 1)});
}

inline ReturnProblem problem(const Route& r) {
  const auto n = static_cast<std::uint32_t>(r.centers.size());
  return return_problem(r, {0, n}, vehicle(), station());
}

}  // namespace furrow::planner::paper_case
