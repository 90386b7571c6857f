#pragma once

#include "app/options.hpp"
#include "core/expected.hpp"
#include "mission/scenario.hpp"
#include "transport/director.hpp"
#include "transport/process.hpp"

#include <optional>
#include <string>
#include <vector>

namespace furrow::app {

/// The processes of a run: one scheduler, one per station, one per agent or group of agents. They
/// end with this object.
class FleetProcesses {
 public:
  /// Starts them all, to meet in `director.network`.
  ///
  /// @error  A sentence: a program is missing, or there are more processes than one DDS domain
  ///         holds, or no such agents that would be remote.
  static Expected<FleetProcesses, std::string> start(const Options& options,
                                                     const mission::Scenario& scenario,
                                                     const transport::DirectorSettings& director);

  std::vector<transport::MemberPlan> members() const;

  /// What starts the processes of remote agents, one shell command each. ADDRESS stands for the
  /// other host's; the scenario file must be the same there.
  const std::vector<std::string>& commands_elsewhere() const { return commands_elsewhere_; }

  /// Participants whose processes have ended.
  std::vector<std::uint32_t> dead();

  /// Whether the scheduler or a station has failed: no mission goes on without them.
  bool is_crippled();

  /// One sentence for each process that failed.
  std::vector<std::string> mishaps() const { return mishaps_; }

  /// `reason`, and what the processes' own ends add to it.
  std::string explanation(const std::string& reason);

 private:
  struct Member {
    transport::MemberPlan plan;
    std::string name;
    std::optional<transport::Process> process;  // none: on another host
    bool has_failed = false;
  };

  std::vector<Member> members_;
  std::vector<std::string> commands_elsewhere_;
  std::vector<std::string> mishaps_;
};

}  // namespace furrow::app
