#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace furrow::app {

/// How fast a run goes.
struct Pace {
  enum class Kind { max, times_real, wall } kind = Kind::max;
  double factor = 1.0;  ///< Times real time, for `times_real`.
};

/// Aircraft by their place in the scenario, 1 <= first <= last.
struct AgentRange {
  std::uint32_t first, last;
};

/// What the command line asks for.
struct Options {
  std::string scenario;               ///< Path of the scenario file.
  std::string out;                    ///< Empty: out/<scenario name>.
  std::optional<std::uint64_t> seed;  ///< Instead of the scenario's.
  Pace pace;
  bool json = false;  ///< result.json to stdout, and nothing else there.
  bool quiet = false;
  std::uint32_t agents_per_process = 0;  ///< 0: one, or as many as fit into 50 processes.
  std::string interface = "127.0.0.1";
  std::optional<AgentRange> remote_agents;  ///< Started by hand on another host; wall clock only.
  std::uint32_t start_in_s = 5;             ///< From starting the processes to the mission's epoch.
  std::string folder;  ///< Results of a mission: finished for export, to come for operate.
  std::string order;   ///< Of the operator.
  std::string uav;     ///< That the order is about; empty: all.
  std::uint32_t patience_s = 10;  ///< Until an order is given up as unanswered.
  std::string format;             ///< Of the missions exported.
  std::string program_folder;     ///< Where the other programs of this build are.
};

/// Exit codes, as every user may rely on them.
enum Exit : int { done = 0, not_met = 1, bad_input = 2, broken = 3 };

int check(const Options& options);
int plan(const Options& options);
int sim(const Options& options);
int run(const Options& options);
int operate(const Options& options);
int export_missions(const Options& options);

}  // namespace furrow::app
