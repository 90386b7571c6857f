#pragma once

#include "exchange/formats/polygons.hpp"
#include "exchange/land.hpp"

namespace furrow::exchange {

/// Most vertices of one polygon.
inline constexpr int most_vertices = 200'000;

/// A polygon of a file as a field in the local frame at its centroid. `features` is left at 0.
Expected<Land, Fault> outline(const FoundPolygon& found);

}  // namespace furrow::exchange
