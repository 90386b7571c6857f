#pragma once

#include "planner/coverage/cover.hpp"
#include "planner/survey/survey.hpp"
#include "planner/terrain/relief.hpp"
#include "scheduler/fleet_plan.hpp"

#include <optional>

namespace furrow::scheduler {

/// A field to spray, or places to visit over it, and what there is to do so with.
struct FleetProblem {
  Field field;
  planner::CoverageModel coverage;           ///< Its direction is the next line's.
  std::optional<double> work_direction_deg;  ///< Clockwise from north; searched when left out.
  std::vector<Station> stations;             ///< At least one.
  std::vector<Vehicle> vehicles;             ///< At least one, ids rising, all of one swath.
  planner::SolveSettings solver;             ///< Its budget is for the whole fleet.
  std::optional<planner::TerrainModel> terrain{};  ///< None: level land.
  std::vector<Vehicle> joining{};  ///< Come after the start: they are given no share.
  /// Then way points are visited and nothing is sprayed; the terrain's work height is the survey's.
  std::optional<planner::SurveySettings> survey{};
};

/// The ways between all stations, homes and strips, at the distances that strips keep. Over terrain
/// with its heights; they lead around keep-out volumes, whatever part of their height is kept out.
/// @error  out_of_reach  A keep-out volume is over a field to spray, or the ceiling is too low for
/// ferries
///         over the highest ground on the way.
/// @error  any other     As planner::FerryMap::over.
Expected<planner::FerryMap, planner::PlanError> ferry_map(const FleetProblem& problem);

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
