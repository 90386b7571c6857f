#include "exchange/land.hpp"

#include "exchange/formats/formats.hpp"
#include "exchange/gdal.hpp"
#include "exchange/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>

namespace furrow::exchange {

namespace {

using namespace std::string_view_literals;

std::string_view without_gap(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  while (!bytes.empty() && std::isspace(static_cast<unsigned char>(bytes.front()))) {
    bytes.remove_prefix(1);
  }
  return bytes;
}

std::optional<Fault> read(const LandFile& file, Polygons& found) {
  const std::string_view bytes = without_gap(file.bytes);
  if (bytes.empty()) return Fault{"must hold a field", "an empty file"};
  if (bytes.starts_with("SQLite format 3\0"sv)) {
    return read_vector_layers(file, Driver::geopackage, found);
  }
  if (bytes.starts_with("\0\0\x27\x0a"sv)) {
    return read_vector_layers(file, Driver::shapefile, found);
  }
  if (bytes.front() == '{') return read_vector_layers(file, Driver::geojson, found);
  if (bytes.front() == '<') return read_xml(file, found);
  const auto word = bytes.substr(0, bytes.find_first_of(" \t\r\n(;="));
  for (const char* geometry : {"SRID", "POLYGON", "MULTIPOLYGON", "CURVEPOLYGON", "MULTISURFACE",
                               "GEOMETRYCOLLECTION", "POINT", "LINESTRING", "MULTIPOINT",
                               "MULTILINESTRING", "TRIANGLE", "TIN", "POLYHEDRALSURFACE"}) {
    if (EQUAL(std::string{word}.c_str(), geometry)) return read_well_known_text(file, found);
  }
  return Fault{"must be GeoJSON, KML, WKT, GML, shapefile, GeoPackage or ISOXML",
               fmt::format("\"{}\"", shown(bytes.substr(0, 12)))};
}

// "3 polygons: 0 north field, 1 south field, 2 nameless".
std::string choices(const Polygons& found) {
  std::string all =
      found.count() == 1 ? "one polygon:" : fmt::format("{} polygons:", found.count());
  for (std::size_t i = 0; i < found.names().size(); ++i) {
    const std::string name = shown(found.names()[i]);
    all += fmt::format("{} {} {}", i > 0 ? "," : "", i, name.empty() ? "nameless" : name);
  }
  return found.count() > found.names().size() ? all + ", ..." : all;
}

Fault no_such_feature(const Polygons& found, std::optional<std::size_t> wanted) {
  if (found.count() > 0) {
    return {wanted ? fmt::format("feature must be 0 to {}, as the file has {}", found.count() - 1,
                                 choices(found))
                   : fmt::format("feature must choose one of {}", choices(found)),
            wanted ? std::to_string(*wanted) : "no feature"};
  }
  return {"must hold a polygon",
          found.others() == 0 ? "no geometry"
                              : fmt::format("only points or lines, {} in number", found.others())};
}

}  // namespace

Expected<Land, LandError> read_land(const LandFile& file, std::optional<std::size_t> feature) {
  const auto error = [&](const Fault& fault) {
    return Unexpected{LandError{file.path, fault.rule, fault.value}};
  };
  Polygons found{feature.value_or(0)};
  if (auto fault = read(file, found)) return error(*fault);
  const bool is_open = !feature && found.count() > 1;
  if (!found.chosen() || is_open) return error(no_such_feature(found, feature));
  auto land = outline(*found.chosen());
  if (!land) return error(land.error());
  land->features = found.count();
  if (land->name.empty()) land->name = shown(std::filesystem::path{file.path}.stem().string());
  return std::move(*land);
}

Expected<Land, LandError> read_land(const std::string& path, std::optional<std::size_t> feature) {
  auto file = land_file(path);
  if (!file) return Unexpected{file.error()};
  return read_land(*file, feature);
}

}  // namespace furrow::exchange
