#pragma once

#include "planner/coverage/swath/order.hpp"

namespace furrow::planner {

enum class Shortening { allowed, refused };

/// Where one strip ends and the next begins around a corner, within half a swath of the crossing of
/// their lines: flies both to the crossing, so that the way between them becomes spray. Only where
/// that makes the route shorter and the two together no shorter.
///
/// @param either  Whether one of the two may become shorter. It then sprays less at its end, which
///                matters unless other strips spray there.
/// @return  Whether one did.
bool join_corners(StripOrder& order, const EdgeGrid& edges, Shortening either);

}  // namespace furrow::planner
