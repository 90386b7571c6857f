#pragma once

#include "scheduler/forecast.hpp"

#include <optional>
#include <span>
#include <vector>

namespace furrow::scheduler {

/// One aircraft's return-point problem within a fleet.
struct FleetTask {
  AgentId agent;
  std::uint32_t station;                          ///< Index into the stations.
  std::optional<planner::ReturnProblem> problem;  ///< None for an empty share.
  std::optional<FlightTimes> times;               ///< Of the problem; none for an empty share.
};

struct FleetReturns {
  std::vector<planner::Solution> solutions;  ///< By task; empty for an empty share.
  Forecast forecast;
};

/// Chooses the return points of all aircraft. `settings.budget_s` is for all of them together.
///
/// By GSA, each aircraft first solves its own problem as if it were alone; then, aircraft by
/// aircraft, again with the waiting it adds at its station, given what the others do, in the
/// objective. Of all that was tried, all aircraft unplanned and all simple included, the plan with
/// the smallest forecast makespan is kept, then with the least time spent. The other strategies
/// know no queue. An aircraft that flies alone gets exactly what `planner::solve` finds for it.
///
/// @error  out_of_reach, tank_too_small  As planner::solve.
Expected<FleetReturns, planner::PlanError> fleet_returns(const std::vector<FleetTask>& tasks,
                                                         std::span<const Station> stations,
                                                         const planner::SolveSettings& settings);

}  // namespace furrow::scheduler
