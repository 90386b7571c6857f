#pragma once

#include "planner/coverage/route.hpp"
#include "planner/coverage/swath/swath.hpp"

namespace furrow::planner {

/// The strips of `coverage`, each cut into equal cells as near to `cell` long as they can be, at
/// least one.
///
/// Cells of strips of different length differ a little. No cell is listed as missed: what the rows
/// leave out has no cells, only an area.
///
/// @param cell  About the swath, > 0.
Route swath_route(const SwathCoverage& coverage, Length cell);

}  // namespace furrow::planner
