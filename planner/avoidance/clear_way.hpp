#pragma once

#include "planner/avoidance/room.hpp"

#include <optional>

namespace furrow::planner {

/// A short way with corners from `from` to `to`, on the land of `room` and clear of its circles and
/// barriers: over corners of octagons around the circles, a hand's breadth outside them. For where
/// a line leaves no room for curves. Circles that hold an end count up to that end only.
///
/// @return  Both ends included; nothing where there is none.
///
/// Cost: A* over eight corners for each circle within 60 m of the straight way; 5 ms for 20 of
/// them.
std::optional<PathM> clear_way(PointM from, PointM to, const Room& room);

}  // namespace furrow::planner
