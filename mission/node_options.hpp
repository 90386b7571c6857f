#pragma once
// What every node process is told on its command line.

#include "core/expected.hpp"
#include "core/ids.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace furrow::mission {

struct NodeOptions {
  /// Whether simulated time is granted step by step or follows the wall clock.
  enum class Mode { granted, wall };
  std::string scenario;               ///< Path of the scenario file.
  std::optional<std::uint64_t> seed;  ///< Instead of the scenario's.
  int domain;                         ///< 0 .. 232.
  std::string run;                    ///< Name of the run; nodes of other runs are not heard.
  int participant;                    ///< 0 .. 119.
  std::string interface;              ///< Network address to use, "127.0.0.1" unless told.
  std::vector<std::string> peers;     ///< Addresses of the hosts of the director and the scheduler.
  Mode mode;
  std::int64_t epoch_ns;      ///< Wall time of mission time zero, since 1970 [ns]; wall mode only.
  std::uint32_t first, last;  ///< The agents hosted, or the station twice; 0 for a scheduler.
  BootId boot;
};

/// Reads `--agents 7`, `--agents 1-50` or `--station 2` and the rest.
/// @error  One line that names the option and its rule.
Expected<NodeOptions, std::string> node_options(int argc, const char* const* argv);

}  // namespace furrow::mission
