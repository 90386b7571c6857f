#pragma once

#include "core/random.hpp"
#include "planner/routes/route_cost.hpp"

#include <vector>

namespace furrow::planner {

/// Way points between start and goal, in order; one or more.
using Genes = std::vector<WayPoint>;

struct Individual {
  Genes genes;
  RouteCost cost;
};

using Population = std::vector<Individual>;

/// A place uniform in the box.
WayPoint scattered(const Scene& scene, Random& random);

/// `p` moved within the box, uniformly in a box around it that spans between all and 1/64 of the
/// scene's, by chance: far enough to change sides of a hill, near enough to settle.
WayPoint moved(const Scene& scene, WayPoint p, Random& random);

}  // namespace furrow::planner
