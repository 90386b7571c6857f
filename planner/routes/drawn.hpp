#pragma once

#include "planner/routes/way_point.hpp"

#include <span>
#include <vector>

namespace furrow::planner {

/// The points of `line` between its ends that keep it within `off_m` of where it was.
/// Source: Ramer 1972, Computer Graphics and Image Processing 1(3), 244-256.
std::vector<WayPoint> drawn(std::span<const WayPoint> line, double off_m);

}  // namespace furrow::planner
