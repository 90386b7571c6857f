#pragma once
// Field A along its rows with a fleet: the cases that fleet plans are measured by.

#include "planner/fleet/problem.hpp"
#include "tests/planner/field_a_rows.hpp"

#include <vector>

namespace furrow::planner::fleet::yardsticks {

struct Yardstick {
  FieldPoint station;
  double service_s;
  std::uint32_t bays, fliers;
  double till_empty_s, to_beat_s, bound_s;
};

inline const std::vector<Yardstick> all{
    {at_m(0, 0), 60, 1, 4, 2672, 2439, 2175},      {at_m(0, 0), 60, 1, 10, 1442, 1442, 834},
    {at_m(0, 0), 180, 1, 4, 3272, 3272, 2760},     {at_m(0, 0), 180, 2, 4, 3044, 3044, 2760},
    {at_m(0, 0), 180, 1, 10, 2042, 2042, 1608},    {at_m(350, -10), 60, 2, 10, 1198, 1080, 788},
    {at_m(350, -10), 180, 1, 6, 2650, 2650, 2328},
};

/// 5 m/s at work and on ferries, 2222 m per tank, packs that last, everybody full at the station.
inline FleetProblem problem(const Yardstick& y) {
  std::vector<StraightStrip> strips;
  for (const Strip& s : field_a_rows::route(metres(2)).strips) strips.push_back({s.begin, s.end});
  FleetProblem p{StripPath{strips}, {}, {{y.station, y.bays, y.service_s}}};
  p.fliers.assign(y.fliers, {.tank_m = 2222, .spray_mps = 5, .ferry_mps = 5, .start = y.station});
  return p;
}

}  // namespace furrow::planner::fleet::yardsticks
