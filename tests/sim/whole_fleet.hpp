#pragma once
// A scenario flown in this process, as the command does.

#include "mission/fleet.hpp"
#include "sim/simulate.hpp"

namespace furrow::sim {

/// Everything said in the mission, the scenario's faults included.
inline Log flown(const mission::Scenario& scenario, const scheduler::FleetPlan& plan) {
  NodeHost host{scenario.link, scenario.seed};
  const auto add = [&](NodeId id, AnyNode node) {
    host.add(id, std::move(node), Instant{}, mission::death(scenario, id));
  };
  add(furrow::scheduler_node(), mission::scheduler_node(scenario, plan));
  for (const Station& s : scenario.stations) {
    add(node(s.id), mission::supply_node(scenario, s.id));
  }
  for (const Vehicle& v : scenario.uavs) {
    const BootId boot = mission::first_boot(scenario, node(v.id));
    add(node(v.id), mission::agent_node(scenario, plan.route.ferries, v.id, boot));
  }
  return simulate(host, scenario.link.latency, Instant{scenario.mission_limit});
}

}  // namespace furrow::sim
