#pragma once
// The central clock of a run and the recorder of all that is said in it.

#include "core/expected.hpp"
#include "core/messages.hpp"
#include "transport/network.hpp"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace furrow::transport {

/// A process to come, and the nodes that it hosts.
struct MemberPlan {
  std::uint32_t participant;
  std::vector<NodeId> nodes;
};

struct DirectorSettings {
  Network network;
  std::vector<MemberPlan> members;
  Duration latency;               ///< Least time of a message on the way, > 0: the lookahead.
  std::optional<double> pace{};   ///< Mission seconds per second, > 0; left out: as fast as can be.
  Instant mission_limit = never;  ///< The run is given up after this instant, which still counts.
  /// The mission's epoch in CLOCK_REALTIME nanoseconds: nothing is granted, only recorded.
  std::optional<std::int64_t> epoch_realtime_ns{};
  std::chrono::milliseconds start_timeout{30'000};  ///< For every member to be there.
  std::chrono::milliseconds stall_timeout{60'000};  ///< Longest step of a member that lives.
  /// Sees every envelope once, ordered by time, sender, sequence number (by arrival on the wall
  /// clock).
  std::function<void(const Envelope&)> observer{};
  /// Asked often: what the director itself has to tell the fleet.
  std::function<std::vector<Body>()> says{};
  std::function<bool()> interrupted{};  ///< Asked often; true ends the run.
  /// Asked often: participants whose processes are known to have ended. They drop out of the run.
  std::function<std::vector<std::uint32_t>()> dead_members{};
};

enum class Ending {
  finished,       ///< The scheduler said so.
  mission_limit,  ///< Time was up.
  idle,           ///< Nothing was going to happen any more.
  interrupted,
  abandoned,  ///< Every member has died.
  failed      ///< The network did, on the way; `reason` says how.
};

struct DirectorResult {
  std::vector<Envelope> log;  ///< All that was sent up to `end`, by time, sender, sequence number.
  Instant end;
  Ending ending;
  std::vector<std::uint32_t> died;   ///< Participants lost on the way.
  std::uint64_t rounds;              ///< Of grants.
  std::uint64_t malformed_messages;  ///< Dropped by the recorder.
  std::string reason{};              ///< A sentence, when the run failed.
};

/// Waits for every member, runs the mission to its end and tells the members to stop. What fails on
/// the way ends the run with all that was recorded before.
///
/// @return  An error when a member does not come, or a port is taken: nothing has run then.
Expected<DirectorResult, TransportError> run_director(const DirectorSettings& settings);

}  // namespace furrow::transport
