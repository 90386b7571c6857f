#pragma once

#include "app/results/report/svg.hpp"

#include <vector>

namespace furrow::app {

/// A chain with fewer points, none of the left-out ones further than `tolerance` from it. The ends
/// stay. Cost: n log n for a track, n^2 at worst.
///
/// Source: Douglas, Peucker 1973.
std::vector<Pixel> simplified(const std::vector<Pixel>& chain, double tolerance);

}  // namespace furrow::app
