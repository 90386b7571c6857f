#pragma once
// Small aircraft from one station at the origin, on routes laid by hand, flown by all parts.

#include "agents/agent_node.hpp"
#include "planner/returns/evaluate.hpp"
#include "scheduler/scheduler_node.hpp"
#include "sim/simulate.hpp"
#include "supply/supply_node.hpp"

#include <optional>

namespace furrow::sim {

/// Sprays 200 s of a tank and flies 600 s of a pack.
inline Vehicle vehicle(AgentId id) {
  return {.id = id,
          .home = at_m(0, 0),
          .swath = metres(4),
          .spray_speed = metres_per_second(3),
          .ferry_speed = metres_per_second(6),
          .spray_endurance = seconds(200),
          .flight_endurance = seconds(600),
          .battery_reserve = 0.1,
          .tank = litres(10),
          .min_turn_radius = metres(0),
          .acceleration_limit = metres_per_second2(3),
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

/// Who flies these strips of a route with these returns.
inline scheduler::UavPlan uav_plan(const planner::Route& route, const Vehicle& vehicle,
                                   CellRange strips, const planner::Returns& returns) {
  const std::uint32_t first = route.strips[strips.first].cells.first;
  const CellRange cells{first, end(route.strips[end(strips) - 1].cells) - first};
  scheduler::UavPlan uav{.vehicle = vehicle,
                         .station = station(),
                         .strips = strips,
                         .cells = cells,
                         .solution = {},
                         .visits = {},
                         .spray_ends_s = 0,
                         .lands_s = 0};
  const auto problem = planner::return_problem(route, cells, vehicle, station());
  uav.solution.plan = planner::evaluated(problem, returns);
  return uav;
}

/// Everything said within an hour, messages 50 ms on their way.
/// @param separation  None: nobody asks for ways.
inline Log flown(const scheduler::FleetPlan& plan, std::optional<Length> separation = {}) {
  constexpr Duration latency{50'000'000}, an_hour{3'600'000'000'000};
  NodeHost host{{.latency = latency, .jitter = {}, .loss = 0, .duplication = 0}, 1};
  host.add(scheduler_node(),
           AnyNode{scheduler::SchedulerNode{{.plan = plan,
                                             .epoch = Epoch{1},
                                             .agent_lease = Duration{5'000'000'000},
                                             .mission_limit = an_hour,
                                             .separation = separation}}},
           Instant{});
  supply::SupplySettings supply{.station = station(), .tanks = {}};
  for (const auto& uav : plan.uavs) supply.tanks[uav.vehicle.id] = uav.vehicle.tank;
  host.add(node(StationId{1}), AnyNode{supply::SupplyNode{supply}}, Instant{});
  for (const auto& uav : plan.uavs) {
    const AgentId id = uav.vehicle.id;
    agents::AgentSettings agent{.vehicle = uav.vehicle,
                                .stations = {station()},
                                .wind = {},
                                .seed = 1,
                                .boot = BootId{number(id)}};
    if (separation) agent.airspace = agents::AirspaceRule{.layer = number(id) * metres(1.5)};
    host.add(node(id), AnyNode{agents::AgentNode{agent}}, Instant{});
  }
  return simulate(host, latency, Instant{an_hour});
}

}  // namespace furrow::sim
