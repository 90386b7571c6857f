// furrow-scheduler: plans the mission and runs the scheduler's node.

#include "mission/fleet.hpp"
#include "process/node_process.hpp"
#include "scheduler/plan_fleet.hpp"

using namespace furrow;

int main(int argc, char** argv) {
  return process::node_process(
      argc, argv,
      [](const mission::Scenario& scenario,
         const mission::NodeOptions&) -> Expected<process::Nodes, std::string> {
        const auto plan = scheduler::plan_fleet(mission::fleet_problem(scenario));
        if (!plan) return Unexpected{plan.error().detail};
        process::Nodes nodes;
        nodes.emplace_back(scheduler_node(), mission::scheduler_node(scenario, *plan));
        return nodes;
      });
}
