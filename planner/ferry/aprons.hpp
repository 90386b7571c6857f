#pragma once

#include "planner/coverage/plane.hpp"

#include <vector>

namespace furrow::planner {

/// The ground around `stand` half as far again as `land` is away, as a polygon; empty where the
/// stand is on the land.
LandParts apron(PointM stand, const LandParts& land);

/// `flight` with the necks of `land` through which its parts are one, clear of `taken`: there the
/// margin from the edges of the land is as large as joins them, a half, a quarter, a tenth or a
/// hundredth. Parts that no neck joins stay apart.
///
/// @param margin_m  By which `flight` was drawn in from `land`, >= 0.
LandParts with_necks(const LandParts& flight, const LandParts& land, const LandParts& taken,
                     double margin_m);

/// Narrow strips of ground that join the parts of `land`, each where two come nearest to each other
/// clear of `taken`. Parts that cannot be joined stay apart.
LandParts bridges(const LandParts& land, const LandParts& taken);

}  // namespace furrow::planner
