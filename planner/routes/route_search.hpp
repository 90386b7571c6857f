#pragma once

#include "planner/routes/population.hpp"

#include <vector>

namespace furrow::planner {

/// What a search for a route ends with, feasible or not.
struct RouteSearch {
  Individual best;
  std::vector<double> history;  ///< Least cost at the start and after each generation.
  double evaluations;           ///< Work spent, in judged curves.
};

}  // namespace furrow::planner
