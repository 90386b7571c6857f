#pragma once

#include "planner/fleet/problem.hpp"

#include <functional>
#include <optional>
#include <span>

namespace furrow::planner::fleet {

/// How far along the path an aircraft can spray from a position on one tank and one pack, leaving
/// `out_from` and landing at `depot`. Not beyond the path's end; `from_m` if it cannot at all.
double reach_m(const FleetProblem& problem, std::uint32_t flier, FieldPoint out_from, double from_m,
               std::uint32_t depot);

/// Hands out the path in order: whoever is the first to be ready takes the next stretch, as far as
/// `end_m(from)` wants it and tank and pack carry it. Lands at the depot nearest to where it stops.
/// @param end_m  From a position to where its sortie should end, beyond it.
/// @return  Nothing if some stretch is out of reach.
std::optional<FleetSorties> dealt_out(const FleetProblem& problem,
                                      const std::function<double(double)>& end_m);

/// Everybody flies until the tank, or the pack, is empty.
std::optional<FleetSorties> till_empty(const FleetProblem& problem);

/// Everybody returns at the last end of a strip that the tank lasts for, among the ends on the
/// depots' side; till empty where there is none.
/// Source: Wang et al. 2017, "simple planning".
std::optional<FleetSorties> simple_sorties(const FleetProblem& problem);

}  // namespace furrow::planner::fleet
