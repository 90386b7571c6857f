#include "app/fleet_processes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace furrow::app {
namespace {

struct Launch {
  transport::MemberPlan plan;
  std::string name;               // for people
  std::string program;            // of this build
  std::vector<std::string> role;  // command-line options of its own
  bool is_remote = false;
};

// How many aircraft each process hosts: as asked, or as few as fit into 50 processes.
std::uint32_t agents_per_process(const Options& options, std::size_t uavs) {
  constexpr std::size_t processes = 50;
  if (options.agents_per_process > 0) return options.agents_per_process;
  return static_cast<std::uint32_t>((uavs + processes - 1) / processes);
}

Launch launch(std::string name, std::string program, std::uint32_t participant,
              std::vector<NodeId> nodes, std::vector<std::string> role = {}) {
  Launch made;
  made.plan = {participant, std::move(nodes)};
  made.name = std::move(name);
  made.program = std::move(program);
  made.role = std::move(role);
  return made;
}

// No process hosts both remote aircraft and others.
void add_agents(std::vector<Launch>& all, const Options& options, const mission::Scenario& scenario,
                std::uint32_t participant) {
  const std::size_t each = agents_per_process(options, scenario.uavs.size());
  const auto is_remote = [&](std::size_t i) {
    const auto& remote = options.remote_agents;
    return remote && i + 1 >= remote->first && i + 1 <= remote->last;
  };
  for (std::size_t first = 0, end = 0; first < scenario.uavs.size(); first = end) {
    const std::size_t most = std::min(first + each, scenario.uavs.size());
    for (end = first + 1; end < most && is_remote(end) == is_remote(first);) ++end;
    std::vector<NodeId> hosted;
    for (std::size_t i = first; i < end; ++i) hosted.push_back(node(scenario.uavs[i].id));
    const std::string range = fmt::format("{}-{}", first + 1, end);
    all.push_back(launch("the process of agents " + range, "furrow-agents", participant++,
                         std::move(hosted), {"--agents", range}));
    all.back().is_remote = is_remote(first);
  }
}

std::vector<Launch> launches(const Options& options, const mission::Scenario& scenario,
                             const transport::Network& network) {
  std::vector<Launch> all{launch("the scheduler", "furrow-scheduler",
                                 transport::scheduler_participant, {scheduler_node()})};
  std::uint32_t participant = transport::first_station_participant;
  for (const Station& station : scenario.stations) {
    const std::string id = std::to_string(number(station.id));
    all.push_back(launch("station " + id, "furrow-supply", participant++, {node(station.id)},
                         {"--station", id}));
  }
  add_agents(all, options, scenario, transport::first_agent_participant(network));
  return all;
}

std::vector<std::string> arguments(const Launch& launch, const Options& options,
                                   const mission::Scenario& scenario,
                                   const transport::DirectorSettings& director) {
  std::vector<std::string> argv{options.program_folder + "/" + launch.program,
                                "--scenario",
                                options.scenario,
                                "--seed",
                                std::to_string(scenario.seed),
                                "--domain",
                                std::to_string(director.network.domain),
                                "--run",
                                director.network.run,
                                "--participant",
                                std::to_string(launch.plan.participant),
                                "--interface",
                                director.network.interface};
  if (director.epoch_realtime_ns) {
    const std::string epoch = std::to_string(*director.epoch_realtime_ns);
    argv.insert(argv.end(), {"--mode", "wall", "--epoch-ns", epoch, "--boot", epoch});
  }
  argv.insert(argv.end(), launch.role.begin(), launch.role.end());
  return argv;
}

// The same process, to be started by hand.
std::string command_elsewhere(const Launch& launch, const Options& options,
                              const mission::Scenario& scenario,
                              const transport::DirectorSettings& director) {
  std::vector<std::string> argv = arguments(launch, options, scenario, director);
  argv.front() = launch.program;
  *std::next(std::find(argv.begin(), argv.end(), "--interface")) = "ADDRESS";
  argv.insert(argv.end(), {"--peer", director.network.interface});
  return fmt::format("{}", fmt::join(argv, " "));
}

}  // namespace

Expected<FleetProcesses, std::string> FleetProcesses::start(
    const Options& options, const mission::Scenario& scenario,
    const transport::DirectorSettings& director) {
  FleetProcesses fleet;
  if (options.remote_agents && options.remote_agents->last > scenario.uavs.size()) {
    return Unexpected{fmt::format("--remote-agents: the scenario has {} aircraft (got {}-{})",
                                  scenario.uavs.size(), options.remote_agents->first,
                                  options.remote_agents->last)};
  }
  for (Launch& launch : launches(options, scenario, director.network)) {
    if (launch.plan.participant > transport::max_participant) {
      return Unexpected{fmt::format(
          "a run has at most {} processes: host more aircraft in each with --agents-per-process",
          transport::max_participant)};
    }
    if (launch.is_remote) {
      fleet.commands_elsewhere_.push_back(command_elsewhere(launch, options, scenario, director));
      fleet.members_.push_back({std::move(launch.plan), std::move(launch.name), std::nullopt});
      continue;
    }
    auto process = transport::Process::spawn(arguments(launch, options, scenario, director));
    if (!process) return Unexpected{process.error().what};
    fleet.members_.push_back({std::move(launch.plan), std::move(launch.name), std::move(*process)});
  }
  return fleet;
}

std::vector<transport::MemberPlan> FleetProcesses::members() const {
  std::vector<transport::MemberPlan> plans;
  for (const Member& member : members_) plans.push_back(member.plan);
  return plans;
}

std::vector<std::uint32_t> FleetProcesses::dead() {
  std::vector<std::uint32_t> participants;
  for (Member& member : members_) {
    if (!member.process) continue;  // its silence tells
    const auto code = member.process->exit_code();
    if (!code) continue;
    participants.push_back(member.plan.participant);
    if (*code == 0) continue;  // ended as it should
    if (!member.has_failed) {
      mishaps_.push_back(fmt::format("{} ended with code {}", member.name, *code));
    }
    member.has_failed = true;
  }
  return participants;
}

bool FleetProcesses::is_crippled() {
  dead();
  return std::any_of(members_.begin(), members_.end(), [](const Member& member) {
    return member.has_failed && member.plan.nodes.front().kind != NodeKind::agent;
  });
}

std::string FleetProcesses::explanation(const std::string& reason) {
  dead();
  std::string text = reason;
  for (const std::string& mishap : mishaps_) text += "; " + mishap;
  return text;
}

}  // namespace furrow::app
