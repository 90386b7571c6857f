#pragma once

#include "planner/fleet/problem.hpp"

#include <cstdint>
#include <vector>

namespace furrow::planner::fleet {

/// One station's part of a fleet problem: its aircraft on a stretch of the path.
struct StationPart {
  FleetProblem problem;  ///< One depot; the path begins at `from_m` of the whole one.
  double from_m;
  std::uint32_t depot;                ///< Of the whole problem.
  std::vector<std::uint32_t> fliers;  ///< Of the whole problem, by aircraft of the part.
};

/// The path cut into one stretch for each station, in the order in which the path passes them, for
/// the aircraft that start nearer to it than to others. Stations without aircraft take no part.
/// Stretches are so long that all parts fly till empty for about as long.
/// @return  Nothing if there are no two parts, or if one does not reach its stretch.
std::vector<StationPart> by_station(const FleetProblem& problem);

/// Sorties of all parts as those of the whole problem.
FleetSorties of_whole(const FleetProblem& problem, const std::vector<StationPart>& parts,
                      const std::vector<FleetSorties>& sorties);

}  // namespace furrow::planner::fleet
