#pragma once

#include "scheduler/fleet_plan.hpp"
#include "scheduler/fleet_problem.hpp"

namespace furrow::scheduler {

/// Plans the mission: covers the field, cuts the route into shares that are predicted to be done at
/// the same time, gives each aircraft a station and chooses the return points. With several
/// aircraft or stations, by `joint` or `gsa` and but for surveys, the joint search begins with that
/// plan. What it finds is taken if its forecast is faster: sorties from anywhere on the route, each
/// to a station of its own (see joint_plan). The plan's route then has the cells in the order
/// flown.
///
/// Without a work direction, the swath model searches its own over the whole circle; of the grid,
/// 0, 90, 180 and 270 degrees are drafted and the one with the smallest forecast makespan is
/// planned. Without a start, the route begins near the first aircraft's home. A survey's route is a
/// tour from there over its way points (see planner::survey_route). The result depends on nothing
/// but the problem.
///
/// Source: Beasley 1983, Omega 11(4), 403-408 (shares cut from one tour).
///
/// @error  swaths_differ   The aircraft do not all spray the same width.
/// @error  tank_too_small  A tank does not last for one cell.
/// @error  any other       As planner::cover and planner::solve.
Expected<FleetPlan, planner::PlanError> plan_fleet(const FleetProblem& problem);

}  // namespace furrow::scheduler
