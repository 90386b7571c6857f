#pragma once
// Land in: a farm's own files as fields in a local metric frame.

#include "core/expected.hpp"
#include "core/field.hpp"
#include "exchange/land_file.hpp"
#include "exchange/local_frame.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace furrow::exchange {

/// One polygon of a land file.
struct Land {
  Field field;  ///< Rings without repeated vertices; not checked for crossings. No obstacles.
  Datum datum;  ///< Origin of the field frame: the centroid of the boundary, to 1e-7 degrees.
  std::optional<Area> stated_area;  ///< As the file says it, where it does.
  std::string name;                 ///< Of the feature, otherwise of the file.
  std::size_t features;             ///< Polygons in the file.
};

/// Reads polygon number `feature`, from 0, of a land file of at most 64 MiB; left out, the file
/// must hold one only.
///
/// Formats, told by content: GeoJSON, KML, WKT (also EWKT, several in a row), GML (also inside a
/// GAOS parcel), shapefile (with its siblings), GeoPackage, ISOXML v3 and v4. Every part of a
/// multipolygon is a feature of its own, except parts that meet at the antimeridian. Holes are
/// kept, heights dropped. Of ISOXML part fields, boundaries (PLN type 1) count as features; water,
/// buildings, roads and obstacles (types 3 to 6) are cut out of them; other zones are ignored.
///
/// Any CRS that PROJ can bring to WGS84. A shapefile without its .prj, a GML file without a srsName
/// and a local CRS are refused: nobody knows where such land lies. WKT without a SRID is WGS84
/// longitude and latitude, as GeoJSON is. Of GML, the URN and URL forms of a CRS ("urn:ogc:def:crs:
/// EPSG::4326") have the axes of the authority, latitude first; "EPSG:4326" has longitude first, as
/// have all other formats.
///
/// @return the field, or why the file is none; never throws, prints, or reads from a network.
Expected<Land, LandError> read_land(const std::string& path,
                                    std::optional<std::size_t> feature = {});
Expected<Land, LandError> read_land(const LandFile& file, std::optional<std::size_t> feature = {});

/// An obstacle of a file.
struct FileObstacle {
  Obstacle obstacle;
  std::string feature;                  ///< Which of the file it is: "feature 2 (tree)".
  std::optional<Length> seen_within{};  ///< As stated, > 0: the plan is not to know it.
  std::optional<Seconds> appears{};     ///< As stated, >= 0.
};

/// Reads obstacles from a GeoJSON file of points, each with its `radius_m` (> 0) and perhaps
/// `seen_within_m` and `appears_s`, and polygons, whose holes do not matter, each perhaps with an
/// `id` or a `name`, into the field frame. An error names the feature.
Expected<std::vector<FileObstacle>, LandError> read_obstacles(const std::string& path,
                                                              const LocalFrame& frame);
Expected<std::vector<FileObstacle>, LandError> read_obstacles(const LandFile& file,
                                                              const LocalFrame& frame);

}  // namespace furrow::exchange
