#pragma once

#include "planner/coverage/swath/order.hpp"

namespace furrow::planner {

/// Where one strip ends and the next begins around a corner, within half a swath of the crossing of
/// their lines: flies both to the crossing, so that the way between them becomes spray. Only where
/// that makes the route shorter and no less is sprayed.
void join_corners(StripOrder& order, const EdgeGrid& edges);

}  // namespace furrow::planner
