#pragma once

#include "planner/avoidance/dubins.hpp"
#include "planner/avoidance/room.hpp"

#include <optional>
#include <vector>

namespace furrow::planner {

/// The way from the end of one strip to the beginning of the next, as it can be flown.
struct Turn {
  std::vector<FieldPoint> way;  ///< Corners of tangents, both ends included.
  Length length;                ///< Along the arcs.
  bool is_inside;               ///< Whether it never leaves the land of the room.
};

/// The shortest Dubins path, or two of them, of turns no tighter than `radius` that is clear of
/// obstacles: inside the land if there is one among those tried, else outside and said so. Tried
/// are the direct path and those over places up to four radii around the way between, in eight
/// headings.
///
/// @param radius  > 0.
/// @return  Nothing where all meet an obstacle.
/// Cost: about 1 ms where the direct path will not do.
std::optional<Turn> strip_turn(Pose from, Pose to, Length radius, const Room& room);

}  // namespace furrow::planner
