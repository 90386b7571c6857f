#pragma once

#include "scheduler/fleet_problem.hpp"

namespace furrow::scheduler {

/// The ways between all stations, homes and strips, at the distances that strips keep. Over terrain
/// with its heights; they lead around each keep-out volume that reaches into the heights of ferries
/// (see planner::Relief::in_the_way), not over or under it.
/// @error  kept_out         Such a volume is over a field to spray, or over a station or a home or
///                          nearer to it than ferries keep, or holds the height of a survey over
///                          one of its way points, or nearer to that than the survey's ways keep;
///                          `at` is its axis.
/// @error  ceiling_too_low  For ferries over the highest ground on the way.
/// @error  any other        As planner::FerryMap::over.
Expected<planner::FerryMap, planner::PlanError> ferry_map(const FleetProblem& problem);

}  // namespace furrow::scheduler
