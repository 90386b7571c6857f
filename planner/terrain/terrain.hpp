#pragma once
// The ground, whichever way it is known.

#include "core/raster.hpp"
#include "planner/terrain/analytic.hpp"
#include "planner/terrain/surface.hpp"

#include <variant>

namespace furrow::planner {

using Terrain = std::variant<AnalyticTerrain, Raster>;

/// The terrain as a surface to ask often. A raster stays as it is, with no error. A formula is
/// tabulated over `extent` at the widest step whose proven error is at most `tolerance`, but
/// coarser where that would take more than 2^22 samples; the surface says the error it has.
///
/// Cost: one exact height per sample, 0.2 us with a dozen peaks.
/// @pre tolerance > 0
Surface surface(const Terrain& terrain, const Extent& extent, Length tolerance = metres(0.1));

}  // namespace furrow::planner
