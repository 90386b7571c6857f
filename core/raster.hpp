#pragma once

#include "core/geometry.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace furrow {

/// Heights above the datum on a square grid aligned with the field frame.
struct Raster {
  FieldPoint south_west;         ///< Of the first sample.
  Length step;                   ///< Between neighbouring samples, > 0; the same on both axes.
  std::uint32_t columns, rows;   ///< Samples eastwards and northwards, each >= 2.
  std::vector<float> heights_m;  ///< columns x rows, from the south-west, eastwards first; finite.
};

/// A rectangle of the field frame, west < east and south < north.
struct Extent {
  FieldPoint south_west, north_east;
};

/// Grows `extent` so far that it holds all within `around` of `p` along either axis.
inline void cover(Extent& extent, FieldPoint p, Length around = {}) {
  extent.south_west.x = std::min(extent.south_west.x, p.x - around);
  extent.south_west.y = std::min(extent.south_west.y, p.y - around);
  extent.north_east.x = std::max(extent.north_east.x, p.x + around);
  extent.north_east.y = std::max(extent.north_east.y, p.y + around);
}

}  // namespace furrow
