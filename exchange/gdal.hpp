#pragma once
// GDAL, tamed: the drivers in use only, no network, no output of its own.

#include <ogr_spatialref.h>

#include <string>

namespace furrow::exchange {

/// While one lives, GDAL writes no message of its own and fetches nothing. Registers the drivers
/// for GeoJSON, shapefile, GeoPackage, ESRI ASCII grid and GeoTIFF, and no others, once per
/// process.
class GdalScope {
 public:
  GdalScope();
  ~GdalScope();
  GdalScope(const GdalScope&) = delete;
  GdalScope& operator=(const GdalScope&) = delete;

  /// The last thing GDAL complained about, on one line; empty if it did not.
  const std::string& complaint() const { return complaint_; }

 private:
  std::string complaint_;
};

/// WGS84 with longitude first.
OGRSpatialReference wgs84();

/// `raw` made fit for one line of a message: no control characters, at most 80 bytes.
std::string shown(std::string_view raw);

}  // namespace furrow::exchange
