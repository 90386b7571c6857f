#pragma once

#include "scheduler/draft.hpp"
#include "scheduler/fleet_problem.hpp"

namespace furrow::scheduler {

/// A covered field with its shares.
struct Sketch {
  planner::Coverage coverage;
  RouteLengths lengths;
  Draft draft;
};

/// Of the directions that the problem leaves open, the sketch with the smallest forecast makespan.
/// A survey's is its tour, or rounds of its aircraft one after another if those are done earlier.
/// @error  out_of_reach  A strip or way point is cut off from the stations, or too near to an
///                       obstacle.
/// @error  any other     As ferry_map and planner::cover.
Expected<Sketch, planner::PlanError> best_sketch(const FleetProblem& problem);

}  // namespace furrow::scheduler
