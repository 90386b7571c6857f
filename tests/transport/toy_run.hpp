#pragma once
// Starts the toy fleet as processes of its own.

#include "toy_fleet.hpp"
#include "transport/director.hpp"
#include "transport/domain_lock.hpp"
#include "transport/process.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace furrow::toy {

struct Run {
  Fleet fleet;
  std::uint32_t domain;
  std::string name = "toy";
  std::uint32_t agents_per_process = 1;
  std::int64_t epoch_realtime_ns = 0;  ///< 0: granted time.
};

inline transport::Network network(const Run& run) {
  return {.domain = run.domain, .run = run.name, .stations = run.fleet.stations};
}

/// Nodes [from, to) of the fleet's list in one process.
struct Part {
  std::uint32_t participant, from, to;
};

/// The scheduler, each station, then the agents' hosts.
inline std::vector<Part> parts(const Run& run) {
  std::vector<Part> all;
  const std::uint32_t centres = 1 + run.fleet.stations;
  for (std::uint32_t i = 0; i < centres; ++i) all.push_back({1 + i, i, i + 1});
  const std::uint32_t end = centres + run.fleet.agents;
  for (std::uint32_t i = centres; i < end; i += run.agents_per_process) {
    all.push_back(
        {static_cast<std::uint32_t>(all.size() + 1), i, std::min(i + run.agents_per_process, end)});
  }
  return all;
}

inline std::vector<transport::MemberPlan> plans(const Run& run) {
  const auto all = nodes(run.fleet);
  std::vector<transport::MemberPlan> plans;
  for (const Part& part : parts(run)) {
    plans.push_back({part.participant, {all.begin() + part.from, all.begin() + part.to}});
  }
  return plans;
}

inline transport::Process start(const Run& run, const Part& part) {
  const auto text = [](auto n) { return std::to_string(n); };
  auto process = transport::Process::spawn(
      {TRANSPORT_MEMBER, text(run.domain), run.name, text(part.participant), text(run.fleet.agents),
       text(run.fleet.stations), text(run.fleet.seconds), text(run.epoch_realtime_ns),
       text(part.from), text(part.to)});
  require(process.has_value(), "the test's own program starts");
  return std::move(*process);
}

/// The fleet's processes by participant.
class Children {
 public:
  explicit Children(const Run& run) {
    for (const Part& part : parts(run)) processes_.emplace(part.participant, start(run, part));
  }

  transport::Process& operator[](std::uint32_t participant) { return processes_.at(participant); }

  /// Those that have ended, as the director wants to know.
  std::vector<std::uint32_t> dead() {
    std::vector<std::uint32_t> found;
    for (auto& [participant, process] : processes_) {
      if (process.exit_code()) found.push_back(participant);
    }
    return found;
  }

  /// Exit codes; -1 for one that does not end in ten seconds.
  std::map<std::uint32_t, int> exit_codes() {
    std::map<std::uint32_t, int> codes;
    for (auto& [participant, process] : processes_) {
      codes[participant] = process.wait(std::chrono::seconds{10}).value_or(-1);
    }
    return codes;
  }

 private:
  std::map<std::uint32_t, transport::Process> processes_;
};

inline transport::DirectorSettings director(const Run& run, Children& children) {
  return {.network = network(run),
          .members = plans(run),
          .latency = bad_radio.latency,
          .dead_members = [&children] { return children.dead(); }};
}

}  // namespace furrow::toy
