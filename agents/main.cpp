// furrow-agents: runs the nodes of one or more simulated aircraft.

#include "mission/fleet.hpp"
#include "process/node_process.hpp"

using namespace furrow;

int main(int argc, char** argv) {
  return process::node_process(
      argc, argv,
      [](const mission::Scenario& scenario,
         const mission::NodeOptions& options) -> Expected<process::Nodes, std::string> {
        if (options.first < 1 || options.last > scenario.uavs.size()) {
          return Unexpected{"--agents: must be within 1-" + std::to_string(scenario.uavs.size()) +
                            " (got " + std::to_string(options.first) + "-" +
                            std::to_string(options.last) + ")"};
        }
        const auto ferries = scheduler::ferry_map(mission::fleet_problem(scenario));
        if (!ferries) return Unexpected{ferries.error().detail};
        process::Nodes nodes;
        for (std::uint32_t number = options.first; number <= options.last; ++number) {
          const AgentId agent{number};
          const bool is_simulated = options.mode == mission::NodeOptions::Mode::granted;
          const BootId boot =
              is_simulated ? mission::first_boot(scenario, node(agent)) : options.boot;
          nodes.emplace_back(node(agent), mission::agent_node(scenario, *ferries, agent, boot));
        }
        return nodes;
      });
}
