#pragma once

#include "planner/fleet/problem.hpp"

namespace furrow::planner::fleet {

/// No plan ends earlier, for there is that much work, however it is shared: spraying, ferries and
/// services of the best split of the path into sorties, dealt out evenly.
///
/// The exact optimum, over the number of sorties and over cuts in cells, of
///
///     (length + v/w (ferries) + services) / sum of v
///
/// where v is an aircraft's spraying speed, v/w the least ratio of it to a ferry speed, and a
/// service is worth its least v times seconds. A cut costs the ways home and out again, less the
/// hop that they replace, at their least in its cell; sorties may outlast the longest tank by one
/// cell; as many sorties as there are aircraft begin without a service. For one aircraft that
/// starts where it is served, and packs that last, it is the makespan's optimum but for the cells.
///
/// @param cell_m  > 0. Time O(length / cell_m), times the sorties if they are fewer than the
/// aircraft.
double work_bound_s(const FleetProblem& problem, double cell_m);

}  // namespace furrow::planner::fleet
