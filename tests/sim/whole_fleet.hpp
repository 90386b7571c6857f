#pragma once
// A scenario flown in this process, as the command does.

#include "mission/fleet.hpp"
#include "sim/simulate.hpp"

namespace furrow::sim {

/// Everything said in the mission, the scenario's faults included.
inline Log flown(const mission::Scenario& scenario, const scheduler::FleetPlan& plan) {
  NodeHost host = mission::whole_fleet(scenario, plan);
  return simulate(host, scenario.link.latency, Instant{scenario.mission_limit});
}

}  // namespace furrow::sim
