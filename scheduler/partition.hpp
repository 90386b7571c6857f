#pragma once

#include "scheduler/share_times.hpp"

#include <cstdint>
#include <vector>

namespace furrow::scheduler {

/// What one aircraft covers, and from where.
struct Share {
  CellRange strips;       ///< May be empty.
  std::uint32_t station;  ///< Index into the stations.
  double finish_s;        ///< Predicted mission time of its last sprayed cell; 0 if empty.
};

/// A route to be cut into one contiguous share of strips per aircraft, in their order.
struct PartitionProblem {
  const planner::Route& route;
  const RouteLengths& lengths;
  /// By aircraft, then by station.
  const std::vector<std::vector<Pace>>& paces;
  /// By aircraft: what its predicted times are multiplied by; for what a pace does not know of, as
  /// battery swaps and queues.
  std::vector<double> stretch;
  /// By aircraft: mission time at which it sets out [s]; all at 0 when left out.
  std::vector<double> ready_s{};
};

/// The cut with the smallest latest predicted finish, within 0.05 s. Each aircraft gets the station
/// from which its share is predicted to be done first.
///
/// Found by bisection on the finish: for a finish T, each aircraft in turn takes all the strips it
/// can spray by T. That is optimal since a share's time neither falls when it grows at its end nor
/// rises when it starts later (for aircraft that ferry at least as fast as they spray, from homes
/// no further from the later start than the way there by the strips left out).
///
/// Time O(cells * stations) per bisection step, of which there are at most 64.
std::vector<Share> partition(const PartitionProblem& problem);

/// The cells of a run of strips; none of an empty one.
CellRange cells_of(const planner::Route& route, CellRange strips);

}  // namespace furrow::scheduler
