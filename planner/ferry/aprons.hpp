#pragma once

#include "planner/coverage/plane.hpp"

#include <vector>

namespace furrow::planner {

/// The ground around `stand` half as far again as `land` is away, as a polygon; empty where the
/// stand is on the land.
LandParts apron(PointM stand, const LandParts& land);

/// Narrow strips of ground that join the parts of `land`, each where two come nearest to each other
/// clear of `taken`. Parts that cannot be joined stay apart.
LandParts bridges(const LandParts& land, const LandParts& taken);

}  // namespace furrow::planner
