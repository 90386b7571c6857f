#include "exchange/formats/vector_layers.hpp"
#include "exchange/gdal.hpp"
#include "exchange/land.hpp"

#include <fmt/format.h>

#include <cmath>

namespace furrow::exchange {

namespace {

std::string text_of(OGRFeature& feature, const char* key) {
  const int at = feature.GetFieldIndex(key);
  return at >= 0 && feature.IsFieldSetAndNotNull(at) ? feature.GetFieldAsString(at) : "";
}

std::string id_of(OGRFeature& feature, std::size_t number) {
  for (const char* key : {"id", "name"}) {
    if (std::string id = text_of(feature, key); !id.empty()) return shown(id);
  }
  return fmt::format("obstacle{}", number);
}

Expected<GeoPoint, Fault> place(const OGRGeometry* geometry, const OGRSpatialReference* crs) {
  const auto* point = dynamic_cast<const OGRPoint*>(geometry);
  if (!point || point->IsEmpty()) {
    return Unexpected{Fault{"obstacles must be points",
                            geometry ? shown(geometry->getGeometryName()) : "no geometry"}};
  }
  GeoPoint at{point->getX(), point->getY()};
  if (crs) {
    const OGRSpatialReference globe = wgs84();
    const std::unique_ptr<OGRCoordinateTransformation> transform{
        OGRCreateCoordinateTransformation(crs, &globe)};
    if (!transform || !transform->Transform(1, &at.lon_deg, &at.lat_deg)) {
      return Unexpected{
          Fault{"CRS must be one that can be brought to WGS84", shown(crs->GetName())}};
    }
  }
  return at;
}

Expected<Obstacle, Fault> obstacle(OGRFeature& feature, const OGRSpatialReference* crs,
                                   const LocalFrame& frame, std::size_t number_in_file) {
  const auto at = place(feature.GetGeometryRef(), crs);
  if (!at) return Unexpected{at.error()};
  const Datum datum = frame.datum();
  const bool is_near = std::abs(at->lat_deg - datum.lat_deg) < 1 &&
                       std::abs(std::remainder(at->lon_deg - datum.lon_deg, 360.0)) < 1;
  if (!is_near) {
    return Unexpected{Fault{"obstacles must lie near the field",
                            fmt::format("{}, {}", at->lon_deg, at->lat_deg)}};
  }
  const std::string stated = text_of(feature, "radius_m");
  const auto radius_m = number(stated);
  if (!radius_m || *radius_m <= 0) {
    return Unexpected{
        Fault{"radius_m must be a number > 0", stated.empty() ? "none" : shown(stated)}};
  }
  return Obstacle{id_of(feature, number_in_file), frame.to_field(*at), metres(*radius_m)};
}

}  // namespace

Expected<std::vector<Obstacle>, LandError> read_obstacles(const LandFile& file,
                                                          const LocalFrame& frame) {
  const GdalScope gdal;
  const auto error = [&](const Fault& fault) {
    return Unexpected{LandError{file.path, fault.rule, fault.value}};
  };
  const OpenLayers open{file, Driver::geojson};
  if (!open.dataset()) return error({"must be a sound GeoJSON file", gdal.complaint()});
  std::vector<Obstacle> obstacles;
  for (OGRLayer* layer : open.dataset()->GetLayers()) {
    for (const auto& feature : *layer) {
      auto next = obstacle(*feature, layer->GetSpatialRef(), frame, obstacles.size() + 1);
      if (!next) return error(next.error());
      obstacles.push_back(std::move(*next));
    }
  }
  return obstacles;
}

Expected<std::vector<Obstacle>, LandError> read_obstacles(const std::string& path,
                                                          const LocalFrame& frame) {
  auto file = land_file(path);
  if (!file) return Unexpected{file.error()};
  return read_obstacles(*file, frame);
}

}  // namespace furrow::exchange
