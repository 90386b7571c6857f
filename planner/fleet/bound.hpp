#pragma once

#include "planner/fleet/bay_bound.hpp"
#include "planner/fleet/problem.hpp"

#include <string_view>

namespace furrow::planner::fleet {

/// No plan of the problem's path, in whatever sorties it is flown, has a shorter makespan.
/// Free order of strips may.
struct LowerBound {
  double makespan_s;
  std::string_view name;  ///< What holds the fleet up: a word or two.
};

/// "farthest point": somebody must spray it and come home, at the faster of both speeds.
LowerBound farthest_point_bound(const FleetProblem& problem);

/// "bay count": the fills that the path takes at least, one after the other on each bay, with the
/// shortest way to the path and back before and after.
LowerBound bay_count_bound(const FleetProblem& problem);

/// The greatest of them, of "work" and of "bays", see `work_bound_s`, `kinds_bound_s` and
/// `bay_bound_s`, and of
/// "filling": what the path takes beyond the first tanks has been filled in, the bays side by side.
///
/// Where makespans end with the last spraying, ways home are capped at some length h: no plan
/// thus relaxed lands later than h at the slowest ferry speed after it has sprayed. The h of the
/// best bound by work is taken.
///
/// @param bays  Prices of bays are searched for no less than by default where they are busy for
///              four fifths of the bound.
LowerBound best_bound(const FleetProblem& problem, const BayBoundSettings& bays = {});

}  // namespace furrow::planner::fleet
