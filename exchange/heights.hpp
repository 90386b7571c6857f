#pragma once
// Terrain in: a digital elevation model as heights on a grid of the field frame.

#include "core/expected.hpp"
#include "core/raster.hpp"
#include "exchange/land_file.hpp"
#include "exchange/local_frame.hpp"

#include <string>

namespace furrow::exchange {

/// Reads the first band of an ESRI ASCII grid (perhaps with its .prj) or a GeoTIFF, of at most 64
/// MiB and 2^26 samples, in metres.
///
/// With a CRS that PROJ knows, heights are brought into `frame`: bilinear on a grid as fine as the
/// file's finer axis, over the rectangle around its corners; beyond the file's edge, its edge goes
/// on. Without a CRS, coordinates are metres of the field frame. Heights stay above the file's own
/// datum.
///
/// @return the grid, or why the file is none: another format, fewer than 2 samples on an axis, a
/// sample without a height or with NODATA or text in its place, a rotated grid; never throws,
/// prints, or reads from a network.
Expected<Raster, LandError> read_heights(const std::string& path, const LocalFrame& frame);
Expected<Raster, LandError> read_heights(const LandFile& file, const LocalFrame& frame);

}  // namespace furrow::exchange
