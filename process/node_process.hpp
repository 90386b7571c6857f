#pragma once
// The course of every node process: read the command line and the scenario, make the nodes, run
// them over the transport until the mission ends.

#include "core/expected.hpp"
#include "core/node.hpp"
#include "mission/node_options.hpp"
#include "mission/scenario.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace furrow::process {

using Nodes = std::vector<std::pair<NodeId, AnyNode>>;

/// Makes the nodes that the options ask for. The error is a sentence for the operator.
using MakeNodes = std::function<Expected<Nodes, std::string>(const mission::Scenario&,
                                                             const mission::NodeOptions&)>;

/// @return  Exit code: 0 when the run ended, 1 when it broke off, 2 on bad input, 3 on an internal
/// error.
int node_process(int argc, char** argv, const MakeNodes& make_nodes);

}  // namespace furrow::process
