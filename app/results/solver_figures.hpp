#pragma once

#include "app/results/result.hpp"

#include <optional>

namespace furrow::app {

/// Sums over the plans of all aircraft, with their yardsticks: the proven bound, flying until the
/// tank is empty, and, for strips sprayed from end to end, the bound for returning anywhere.
SolverFigures solver_figures(const MissionRecord& record);

/// A plan with waits in its objective may still reach the bound without them.
bool is_proven(const planner::Solution& solution);

/// value / bound - 1; none without a bound, unless there is nothing to compare.
std::optional<double> gap_above(double value, double bound);

}  // namespace furrow::app
