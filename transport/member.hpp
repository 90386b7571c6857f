#pragma once
// The shell of a process of the fleet.

#include "core/node_host.hpp"
#include "transport/network.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace furrow::transport {

struct MemberSettings {
  Network network;
  std::uint32_t participant;  ///< See Network.
  std::vector<NodeId> nodes;  ///< Those that the host holds.
  BootId boot{1};             ///< Of this process; travels in every header.
  /// The mission's epoch in CLOCK_REALTIME nanoseconds. Left out, the director grants time.
  std::optional<std::int64_t> epoch_realtime_ns{};
  /// Told of each participant that has died or gone silent; called from the member's own thread.
  std::function<void(std::uint32_t participant)> peer_lost{};
};

/// Runs the host's nodes as one process of the fleet until the run ends.
///
/// Granted time: the host steps as far as the director's grants reach; its link is the run's.
/// Wall clock: nodes wake by CLOCK_REALTIME and messages are taken as they come, so the host's link
/// should have 1 ns of latency and neither jitter nor loss. Ends a second after the scheduler says
/// that it has finished, or at SIGTERM.
///
/// @return  Exit code: 0 when the run ended, 1 with a line on stderr when it broke off.
int run_member(const MemberSettings& settings, NodeHost host);

/// Mission time on the wall clock.
Instant mission_now(std::int64_t epoch_realtime_ns);

}  // namespace furrow::transport
