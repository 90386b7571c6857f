// furrow-supply: runs the node of one supply station.

#include "mission/fleet.hpp"
#include "process/node_process.hpp"

#include <algorithm>

using namespace furrow;

int main(int argc, char** argv) {
  return process::node_process(
      argc, argv,
      [](const mission::Scenario& scenario,
         const mission::NodeOptions& options) -> Expected<process::Nodes, std::string> {
        const StationId id{options.first};
        const bool is_known = std::any_of(scenario.stations.begin(), scenario.stations.end(),
                                          [&](const Station& s) { return s.id == id; });
        if (!is_known) {
          return Unexpected{"--station: must be one of the scenario's (got " +
                            std::to_string(options.first) + ")"};
        }
        process::Nodes nodes;
        nodes.emplace_back(node(id), mission::supply_node(scenario, id));
        return nodes;
      });
}
