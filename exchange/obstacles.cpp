#include "core/spelling.hpp"
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

std::string feature_text(OGRFeature& feature, std::size_t number) {
  for (const char* key : {"id", "name"}) {
    if (std::string id = text_of(feature, key); !id.empty()) {
      return fmt::format("feature {} ({})", number, shown(id));
    }
  }
  return fmt::format("feature {}", number);
}

bool is_above_0(double x) { return x > 0; }
bool is_at_least_0(double x) { return x >= 0; }

// A property that no obstacle has, but for a slip of the pen: other properties may be anybody's.
std::optional<Fault> misspelt(OGRFeature& feature) {
  constexpr std::size_t slips = 2;
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    const std::string_view name = feature.GetFieldDefnRef(i)->GetNameRef();
    if (!feature.IsFieldSetAndNotNull(i)) continue;
    for (const std::string_view key : {"radius_m", "seen_within_m", "appears_s"}) {
      const std::size_t distance = edit_distance(name.substr(0, 100), key);
      if (distance == 0 || distance > slips) continue;
      return Fault{fmt::format("properties must be spelt as {} is", key), shown(std::string{name})};
    }
  }
  return std::nullopt;
}

// A number that a feature may state.
Expected<std::optional<double>, Fault> stated(OGRFeature& feature, const char* key,
                                              const char* rule, bool (*holds)(double)) {
  const std::string text = text_of(feature, key);
  if (text.empty()) return std::optional<double>{};
  const int at = feature.GetFieldIndex(key);
  const bool is_truth = feature.GetFieldDefnRef(at)->GetSubType() == OFSTBoolean;
  const auto value = is_truth ? std::nullopt : number(text);
  if (value && holds(*value)) return value;
  return Unexpected{Fault{fmt::format("{} must be a number {}", key, rule), shown(text)}};
}

// Places of a file in the field frame.
class Places {
 public:
  Places(const OGRSpatialReference* crs, const LocalFrame& frame)
      : crs_{crs}, frame_{frame}, globe_{wgs84()} {
    if (crs) transform_.reset(OGRCreateCoordinateTransformation(crs, &globe_));
  }

  Expected<FieldPoint, Fault> at(const OGRSimpleCurve& curve, int index) const {
    return at(curve.getX(index), curve.getY(index));
  }

  Expected<FieldPoint, Fault> at(double x, double y) const {
    GeoPoint on{x, y};
    if (crs_ && (!transform_ || !transform_->Transform(1, &on.lon_deg, &on.lat_deg))) {
      return Unexpected{
          Fault{"CRS must be one that can be brought to WGS84", shown(crs_->GetName())}};
    }
    const Datum datum = frame_.datum();
    const bool is_near = std::abs(on.lat_deg - datum.lat_deg) < 1 &&
                         std::abs(std::remainder(on.lon_deg - datum.lon_deg, 360.0)) < 1;
    if (is_near) return frame_.to_field(on);
    return Unexpected{
        Fault{"obstacles must lie near the field", fmt::format("{}, {}", on.lon_deg, on.lat_deg)}};
  }

 private:
  const OGRSpatialReference* crs_;
  const LocalFrame& frame_;
  OGRSpatialReference globe_;
  std::unique_ptr<OGRCoordinateTransformation> transform_{};
};

Expected<Obstacle, Fault> polygon_obstacle(const OGRPolygon& polygon, std::string id,
                                           const Places& places) {
  if (polygon.getNumInteriorRings() > 0) {
    return Unexpected{Fault{"an obstacle must have no holes",
                            fmt::format("{} inner rings", polygon.getNumInteriorRings())}};
  }
  const OGRLinearRing* outer = polygon.getExteriorRing();
  Ring ring;
  for (int i = 0; outer && i < outer->getNumPoints(); ++i) {
    const auto at = places.at(*outer, i);
    if (!at) return Unexpected{at.error()};
    if (ring.empty() || !(ring.back() == *at)) ring.push_back(*at);
  }
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) {
    return Unexpected{Fault{"an obstacle must have 3 vertices", std::to_string(ring.size())}};
  }
  return outlined(std::move(id), std::move(ring));
}

Expected<Obstacle, Fault> obstacle(OGRFeature& feature, const Places& places,
                                   std::size_t number_in_file) {
  const OGRGeometry* geometry = feature.GetGeometryRef();
  std::string id = id_of(feature, number_in_file);
  if (const auto* polygon = dynamic_cast<const OGRPolygon*>(geometry)) {
    return polygon_obstacle(*polygon, std::move(id), places);
  }
  const auto* point = dynamic_cast<const OGRPoint*>(geometry);
  if (!point || point->IsEmpty()) {
    return Unexpected{Fault{"obstacles must be points or polygons",
                            geometry ? shown(geometry->getGeometryName()) : "no geometry"}};
  }
  const auto at = places.at(point->getX(), point->getY());
  if (!at) return Unexpected{at.error()};
  const auto radius_m = stated(feature, "radius_m", "> 0", is_above_0);
  if (!radius_m) return Unexpected{radius_m.error()};
  if (!*radius_m) return Unexpected{Fault{"radius_m must be a number > 0", "none"}};
  return Obstacle{std::move(id), *at, metres(**radius_m)};
}

Expected<FileObstacle, Fault> file_obstacle(OGRFeature& feature, const Places& places,
                                            std::size_t number_in_file) {
  if (auto fault = misspelt(feature)) return Unexpected{std::move(*fault)};
  auto what = obstacle(feature, places, number_in_file);
  if (!what) return Unexpected{what.error()};
  FileObstacle made{std::move(*what), feature_text(feature, number_in_file)};
  const auto seen_m = stated(feature, "seen_within_m", "> 0", is_above_0);
  if (!seen_m) return Unexpected{seen_m.error()};
  if (*seen_m) made.seen_within = metres(**seen_m);
  const auto appears_s = stated(feature, "appears_s", ">= 0", is_at_least_0);
  if (!appears_s) return Unexpected{appears_s.error()};
  if (*appears_s) made.appears = seconds(**appears_s);
  return made;
}

}  // namespace

Expected<std::vector<FileObstacle>, LandError> read_obstacles(const LandFile& file,
                                                              const LocalFrame& frame) {
  const GdalScope gdal;
  const auto error = [&](const Fault& fault) {
    return Unexpected{LandError{file.path, fault.rule, fault.value}};
  };
  const OpenLayers open{file, Driver::geojson};
  if (!open.dataset()) return error({"must be a sound GeoJSON file", gdal.complaint()});
  std::vector<FileObstacle> obstacles;
  for (OGRLayer* layer : open.dataset()->GetLayers()) {
    const Places places{layer->GetSpatialRef(), frame};
    for (const auto& feature : *layer) {
      const std::size_t number = obstacles.size() + 1;
      auto next = file_obstacle(*feature, places, number);
      if (!next) {
        const Fault& fault = next.error();
        return error({fault.rule, feature_text(*feature, number) + ": " + fault.value});
      }
      obstacles.push_back(std::move(*next));
    }
  }
  return obstacles;
}

Expected<std::vector<FileObstacle>, LandError> read_obstacles(const std::string& path,
                                                              const LocalFrame& frame) {
  auto file = land_file(path);
  if (!file) return Unexpected{file.error()};
  return read_obstacles(*file, frame);
}

}  // namespace furrow::exchange
