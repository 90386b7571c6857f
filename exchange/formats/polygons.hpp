#pragma once

#include "core/units.hpp"

#include <ogr_geometry.h>
#include <ogr_spatialref.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace furrow::exchange {

/// What is wrong with the content of a land file.
struct Fault {
  std::string rule, value;
};

/// What a file says of a geometry.
struct Tag {
  std::string name = {};
  std::optional<Area> stated_area = {};
  const OGRSpatialReference* crs = nullptr;  ///< Null where the file states none.
};

/// One polygon, in the coordinates of its file.
struct FoundPolygon {
  std::unique_ptr<OGRPolygon> polygon;
  std::unique_ptr<OGRSpatialReference> crs;
  std::string name;
  std::optional<Area> stated_area;
};

/// Counts the polygons of a file and keeps one of them.
class Polygons {
 public:
  explicit Polygons(std::size_t wanted) : wanted_{wanted} {}

  /// Takes the polygons of any geometry; other geometries are only counted. A stated area is kept
  /// if the geometry is one polygon.
  void add(const OGRGeometry& geometry, const Tag& tag);

  std::size_t count() const { return count_; }
  std::size_t others() const { return others_; }  ///< Geometries that held no polygon.
  /// Of the first polygons in order, empty where they have none.
  const std::vector<std::string>& names() const { return names_; }
  FoundPolygon* chosen() { return chosen_ ? &*chosen_ : nullptr; }

 private:
  void take(const OGRPolygon& polygon, const Tag& tag);

  std::size_t wanted_, count_ = 0, others_ = 0;
  std::vector<std::string> names_;
  std::optional<FoundPolygon> chosen_;
};

/// The area that a property states, if its name is one of the common ones: area_ha, area_m2, ...
std::optional<Area> stated_area(std::string_view key, std::string_view value);

/// The whole of `text` as a finite number.
std::optional<double> number(std::string_view text);

}  // namespace furrow::exchange
