#pragma once

#include "planner/coverage/swath/groups.hpp"
#include "planner/coverage/swath/settings.hpp"

#include <vector>

namespace furrow::planner {

/// Rounds along the edges, and what is left for rows inside them.
struct Headland {
  std::vector<StripGroup> rounds;  ///< One group for each closed round, from the edge inwards.
  LandParts inner;                 ///< May be empty or in several pieces.
};

/// Lays `passes` rounds one swath apart, the first half a swath from the edge of the land.
///
/// @param flight  A part of the land, drawn in by `margin_m`.
Headland headland(const LandPart& flight, double swath_m, double margin_m, int passes,
                  HeadlandTurn turn);

}  // namespace furrow::planner
