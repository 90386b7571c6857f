#include "process/node_process.hpp"

#include "core/require.hpp"
#include "mission/fleet.hpp"
#include "mission/load.hpp"
#include "transport/member.hpp"

#include <cstdio>

namespace furrow::process {
namespace {

constexpr int bad_input = 2;

transport::MemberSettings member_settings(const mission::Scenario& scenario,
                                          const mission::NodeOptions& options) {
  transport::MemberSettings settings{
      .network = {.domain = static_cast<std::uint32_t>(options.domain),
                  .run = options.run,
                  .stations = static_cast<std::uint32_t>(scenario.stations.size()),
                  .interface = options.interface,
                  .peers = options.peers},
      .participant = static_cast<std::uint32_t>(options.participant),
      .nodes = {},
      .boot = options.boot};
  if (options.mode == mission::NodeOptions::Mode::wall) {
    settings.epoch_realtime_ns = options.epoch_ns;
  }
  return settings;
}

// On the wall clock the network itself delays and loses; nothing is added.
constexpr Link real_radio{
    .latency = Duration{1}, .jitter = Duration{0}, .loss = 0.0, .duplication = 0.0};

int run(const mission::NodeOptions& options, const MakeNodes& make_nodes) {
  auto scenario = mission::load(options.scenario);
  if (!scenario) {
    for (const auto& error : scenario.error()) {
      std::fprintf(stderr, "%s\n", mission::text(error).c_str());
    }
    return bad_input;
  }
  if (options.seed) scenario->seed = scenario->solver.seed = *options.seed;

  auto nodes = make_nodes(*scenario, options);
  if (!nodes) {
    std::fprintf(stderr, "furrow: %s\n", nodes.error().c_str());
    return bad_input;
  }
  transport::MemberSettings settings = member_settings(*scenario, options);
  NodeHost host{settings.epoch_realtime_ns ? real_radio : scenario->link, scenario->seed};
  for (auto& [id, node] : *nodes) {
    settings.nodes.push_back(id);
    host.add(id, std::move(node), mission::birth(*scenario, id), mission::death(*scenario, id));
  }
  return transport::run_member(settings, std::move(host));
}

}  // namespace

int node_process(int argc, char** argv, const MakeNodes& make_nodes) {
  try {
    const auto options = mission::node_options(argc, argv);
    if (!options) {
      std::fprintf(stderr, "furrow: %s\n", options.error().c_str());
      return bad_input;
    }
    return run(*options, make_nodes);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "furrow: internal error: %s\n", error.what());
    return internal_error;
  }
}

}  // namespace furrow::process
