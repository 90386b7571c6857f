#pragma once

#include "planner/routes/route_search.hpp"

#include <span>

namespace furrow::planner {

/// The way points of `line` that a straight pull keeps: from each, on to the furthest that is in
/// clear sight at steps of `step_m`. First and last stay.
std::vector<WayPoint> pulled(const std::vector<WayPoint>& line, RouteJudge& judge, double step_m);

/// The cheapest curve near a polyline from start to goal: through its corners, and through 1 to
/// 20 places at equal distances along it. Up to 21 evaluations.
Individual fitted(const std::vector<WayPoint>& line, RouteJudge& judge);

/// `one` after single way points have moved, been taken out or put in for as long as that cost
/// less, until `evaluations` are spent in all.
Individual settled(Individual one, RouteJudge& judge, double evaluations, Random& random);

}  // namespace furrow::planner
