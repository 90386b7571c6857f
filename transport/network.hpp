#pragma once

#include "core/ids.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace furrow::transport {

/// Where a run's processes meet. The same for all of them, `interface` apart.
///
/// Every process is a participant with a number fixed in advance: 0 the director, 1 the scheduler,
/// 2 .. 1 + stations the supply stations, the agents' processes from there on. Agents announce
/// themselves to the first three only.
struct Network {
  std::uint32_t domain;                 ///< 0 .. 100; see DomainLock.
  std::string run;                      ///< Runs of different names do not hear each other.
  std::uint32_t stations;               ///< How many processes host stations.
  std::string interface = "127.0.0.1";  ///< IPv4 address that this process binds to.
  /// IPv4 addresses of other hosts where the director, the scheduler or stations are. Those need
  /// not name the hosts of agents: they answer whoever announces itself.
  std::vector<std::string> peers{};
};

inline constexpr std::uint32_t director_participant = 0;
inline constexpr std::uint32_t scheduler_participant = 1;
inline constexpr std::uint32_t first_station_participant = 2;
inline constexpr std::uint32_t max_domain = 100;
inline constexpr std::uint32_t max_participant = 119;  // ports of one domain, as RTPS lays them out

/// The number of the first process of agents.
constexpr std::uint32_t first_agent_participant(const Network& n) {
  return first_station_participant + n.stations;
}

/// Why the network would not do as asked, in a sentence for the operator.
struct TransportError {
  std::string what;
};

}  // namespace furrow::transport
