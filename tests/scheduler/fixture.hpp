#pragma once
// Small routes, aircraft and fleet plans for tests of the scheduler.

#include "scheduler/fleet_plan.hpp"
#include "scheduler/fleet_problem.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace furrow::scheduler {

/// `strips` strips of `cells` cells each, 2 m apart, back and forth along +y, side by side along
/// +x.
inline planner::Route comb(std::uint32_t strips, std::uint32_t cells) {
  planner::Route route{.cell = metres(2), .centers = {}, .strips = {}, .missed = {}};
  for (std::uint32_t s = 0; s < strips; ++s) {
    for (std::uint32_t c = 0; c < cells; ++c) {
      const std::uint32_t row = s % 2 == 0 ? c : cells - 1 - c;
      route.centers.push_back(at_m(2.0 * s + 1.0, 2.0 * row + 1.0));
    }
    const CellRange range{s * cells, cells};
    route.strips.push_back(planner::centre_strip(range, route.centers[range.first],
                                                 route.centers[end(range) - 1], s > 0));
  }
  return route;
}

/// The aircraft of Wang et al. 2017, section 3.
inline Vehicle vehicle(std::uint32_t id) {
  return {.id = AgentId{id},
          .home = at_m(0, 0),
          .swath = metres(2),
          .spray_speed = metres_per_second(3),
          .ferry_speed = metres_per_second(6),
          .spray_endurance = seconds(900.0),
          .flight_endurance = seconds(1500.0),
          .battery_reserve = 0.0,
          .tank = litres(10),
          .min_turn_radius = metres(0),
          .acceleration_limit = metres_per_second2(3),
          .gnss = {}};
}

inline Station station(std::uint32_t id, std::uint32_t bays = 1, FieldPoint position = at_m(0, 0)) {
  return {.id = StationId{id},
          .position = position,
          .bays = bays,
          .battery_swap = seconds(60.0),
          .fill_base = seconds(20.0),
          .fill_full = seconds(60.0)};
}

/// One aircraft's share and returns, with no figures.
inline UavPlan uav_plan(const planner::Route& route, std::uint32_t id, CellRange strips,
                        planner::Returns returns) {
  UavPlan uav{.vehicle = vehicle(id),
              .station = station(1),
              .strips = strips,
              .cells = {0, 0},
              .solution = {},
              .visits = {},
              .spray_ends_s = 0,
              .lands_s = 0};
  if (strips.count > 0) {
    uav.cells.first = route.strips[strips.first].cells.first;
    uav.cells.count = end(route.strips[end(strips) - 1].cells) - uav.cells.first;
  }
  uav.solution.plan.returns = std::move(returns);
  return uav;
}

/// A field with its south-west corner at the origin, a station there and alike aircraft.
inline FleetProblem problem(double width_m, double length_m, std::uint32_t uavs) {
  FleetProblem p{.field = {.boundary = {at_m(0, 0), at_m(width_m, 0), at_m(width_m, length_m),
                                        at_m(0, length_m)},
                           .holes = {},
                           .obstacles = {}},
                 .coverage = {},
                 .work_direction_deg = 0.0,
                 .stations = {station(1)},
                 .vehicles = {},
                 .solver = {.returns = planner::ReturnStrategy::gsa,
                            .refine = true,
                            .paper_counting = false,
                            .iterations = 20,
                            .masses = 10,
                            .budget_s = 1,
                            .seed = 1}};
  for (std::uint32_t i = 1; i <= uavs; ++i) p.vehicles.push_back(vehicle(i));
  return p;
}

}  // namespace furrow::scheduler
