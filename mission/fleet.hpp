#pragma once
// From a scenario to the nodes that fly it: the same for the simulator and for every process.

#include "core/node.hpp"
#include "core/node_host.hpp"
#include "mission/scenario.hpp"
#include "scheduler/fleet_ferries.hpp"
#include "scheduler/fleet_plan.hpp"

namespace furrow::mission {

/// Everything that planning depends on.
scheduler::FleetProblem fleet_problem(const Scenario& scenario);

/// The incarnation of a node that starts once: a function of the seed, as simulated time needs it.
BootId first_boot(const Scenario& scenario, NodeId node);

/// When the node starts: at the epoch, unless the scenario's faults have it join later.
Instant birth(const Scenario& scenario, NodeId node);

/// When the scenario's faults kill the node; `never` if they do not.
Instant death(const Scenario& scenario, NodeId node);

AnyNode scheduler_node(const Scenario& scenario, const scheduler::FleetPlan& plan);

/// @pre The scenario has the station, or the agent.
AnyNode supply_node(const Scenario& scenario, StationId station);
/// @param ferries  Of the scenario, as `scheduler::ferry_map` makes it and its plan holds it.
AnyNode agent_node(const Scenario& scenario, const planner::FerryMap& ferries, AgentId agent,
                   BootId boot);

/// All nodes of the mission in one host, to join and die as the scenario's faults say.
NodeHost whole_fleet(const Scenario& scenario, const scheduler::FleetPlan& plan);

}  // namespace furrow::mission
