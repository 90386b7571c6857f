#pragma once

#include "planner/fleet/problem.hpp"

namespace furrow::planner::fleet {

/// No plan ends earlier, for there is that much work, shared by aircraft that differ.
///
/// Let kind k have N_k aircraft, and weights w_k with sum N_k w_k = 1. The makespan T is at least
/// the sum of all flights and services, each by the weight of who flies it. So T is at least the
/// cheapest split of the path into sorties with a kind for each,
///
///     sum over sorties of  w_k (spraying / v_k + ferries / f_k + service + filling)
///       - sum over k of  N_k w_k (service + a whole filling),
///
/// for as many sorties as there are aircraft begin without either; later where aircraft fly for a
/// part of the time only. Found exactly over cuts in
/// cells, with the ways out and home at their least in each; weights are searched for on coarser
/// cells, beginning with those that make all spraying cost the same. Fleets of more than six kinds
/// keep those.
///
/// @param cell_m  > 0. Time O(length / cell_m x kinds).
double kinds_bound_s(const FleetProblem& problem, double cell_m);

}  // namespace furrow::planner::fleet
