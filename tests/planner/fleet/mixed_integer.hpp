#pragma once
// A small mixed-integer model of a fleet on one station, solved by GLPK: a second opinion.

#include "planner/fleet/problem.hpp"

#include <vector>

namespace furrow::planner::fleet {

/// Shortest makespan of all plans that cut at some of `cuts_m`, with at most `most_sorties` for
/// each aircraft. Aircraft may also wait, and be served in any order.
/// @pre One depot, of one bay; all packs last.
double mixed_integer_makespan_s(const FleetProblem& problem, const std::vector<double>& cuts_m,
                                int most_sorties);

}  // namespace furrow::planner::fleet
