#pragma once

#include "scheduler/fleet_problem.hpp"

namespace furrow::scheduler {

/// The ways between all stations, homes and strips, at the distances that strips keep. Over terrain
/// with its heights; they lead around keep-out volumes, whatever part of their height is kept out.
/// @error  out_of_reach  A keep-out volume is over a field to spray, or the ceiling is too low for
/// ferries
///         over the highest ground on the way.
/// @error  any other     As planner::FerryMap::over.
Expected<planner::FerryMap, planner::PlanError> ferry_map(const FleetProblem& problem);

}  // namespace furrow::scheduler
