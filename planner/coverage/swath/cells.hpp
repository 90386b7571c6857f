#pragma once

#include "planner/coverage/swath/edge_grid.hpp"
#include "planner/coverage/swath/strips.hpp"

#include <vector>

namespace furrow::planner {

/// Cuts `part` along rows through every reflex vertex at which a line that sweeps across the rows
/// splits, merges or changes its length at once. Along `frame`, every cell is one row wide or
/// tapers; it has no dents.
///
/// Source: Choset 2000, boustrophedon decomposition.
LandParts row_cells(const LandPart& part, const EdgeGrid& edges, RowFrame frame);

/// Directions along the longer edges of `part`, the longest first, no two within a millirad.
std::vector<RowFrame> edge_directions(const LandPart& part, std::size_t most);

}  // namespace furrow::planner
