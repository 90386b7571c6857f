#pragma once

#include "app/results/mission_record.hpp"

#include <map>
#include <optional>
#include <vector>

namespace furrow::app {

/// A stretch of time in one phase.
struct Span {
  double from_s, to_s;
  Phase phase;
};

/// What one aircraft did.
struct FlownUav {
  std::vector<SortieReport> sorties;
  std::vector<TrackPoint> track;
  FlightRecord::Deviation truth{}, fix{};
  std::vector<Span> phases;  ///< Contiguous, as its heartbeats told: to the second.
};

/// One pass over a cell with the valve open.
struct Pass {
  std::uint32_t cell;
  double offset_m;  ///< True cross-track offset, right of the flown direction positive.
};

/// What a log tells, sorted by what it is about.
struct Flown {
  std::vector<FlownUav> uavs;         ///< As in the plan.
  std::vector<Pass> passes;           ///< In the log's order.
  std::vector<std::uint32_t> proofs;  ///< Per cell of the route: closed grants that sprayed it.
  std::optional<SchedulerState> last_word;
  std::map<StationId, StationState> stations;  ///< The last of each.
  std::map<AgentId, Instant> lost;             ///< When the scheduler first said so.
  OperatorState ordered;  ///< The last word of the operator; `fly` without one.
  double last_spray_s;    ///< Mission time of the last sprayed cell.
  double ended_s;         ///< Mission time of the last message.
};

/// Reads the log once. Cells that the route does not have are passed over.
Flown flown(const MissionRecord& record);

}  // namespace furrow::app
