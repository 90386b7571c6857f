#include "exchange/formats/vector_layers.hpp"

#include "exchange/gdal.hpp"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <string_view>

namespace furrow::exchange {

namespace {

struct DriverNames {
  const char* of_driver;
  const char* extension;
};

DriverNames names(Driver driver) {
  switch (driver) {
    case Driver::geojson: return {"GeoJSON", "geojson"};
    case Driver::shapefile: return {"ESRI Shapefile", "shp"};
    case Driver::geopackage: return {"GPKG", "gpkg"};
  }
  return {};
}

Tag tag(const OGRFeature& feature, const OGRSpatialReference* crs) {
  Tag tag{.crs = crs};
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    if (!feature.IsFieldSetAndNotNull(i)) continue;
    const char* key = feature.GetFieldDefnRef(i)->GetNameRef();
    const std::string value = feature.GetFieldAsString(i);
    if (!tag.stated_area) tag.stated_area = stated_area(key, value);
    if (tag.name.empty() && (EQUAL(key, "name") || EQUAL(key, "field_name"))) tag.name = value;
  }
  return tag;
}

// The four bytes at `at`, most significant first.
std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i) {
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

// GDAL restores a missing index record by record, and never ends where a length leads backwards.
// Source: ESRI Shapefile Technical Description, 1998: lengths are in words of 2 bytes.
bool has_sound_records(std::string_view bytes) {
  constexpr std::size_t header = 100, record_header = 8;
  if (bytes.size() < header) return false;
  const std::size_t end = std::size_t{2} * big_endian(bytes, 24);
  std::size_t at = header;
  while (at < end) {
    if (at + record_header > bytes.size()) return false;
    at += record_header + std::size_t{2} * big_endian(bytes, at + 4);
  }
  return at == end && end <= bytes.size();
}

Fault no_crs(Driver driver) {
  switch (driver) {
    case Driver::geojson:
      return {"crs must be one that PROJ knows, or left out for WGS84", "another"};
    case Driver::shapefile: return {"must have its CRS in a .prj file beside it", "none"};
    case Driver::geopackage: return {"must say its CRS", "none"};
  }
  return {};
}

// GDAL takes a CRS of GeoJSON that it does not know for WGS84: what is wrong with that of the file.
std::optional<Fault> geojson_crs_fault(const std::string& bytes) {
  using Json = nlohmann::json;
  if (bytes.find("\"crs\"") == std::string::npos) return std::nullopt;
  bool is_crs = false;
  const auto only_crs = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (depth == 1 && event == Json::parse_event_t::key) is_crs = parsed == "crs";
    return depth == 0 || is_crs;
  };
  const Json top = Json::parse(bytes, only_crs, false);
  if (!top.is_object() || !top.contains("crs")) return std::nullopt;
  const std::string rule = "crs must be one that PROJ knows, or left out for WGS84";
  if (top["crs"].is_null()) return Fault{rule, "null"};
  const auto pointer = Json::json_pointer{"/crs/properties/name"};
  if (!top.contains(pointer) || !top[pointer].is_string()) return Fault{rule, "no name"};
  const std::string name = top[pointer];
  OGRSpatialReference crs;
  const auto fault = crs.SetFromUserInput(
      name.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get());
  return fault == OGRERR_NONE ? std::nullopt : std::optional{Fault{rule, shown(name)}};
}

}  // namespace

OpenLayers::OpenLayers(const LandFile& file, Driver driver) {
  const auto [of_driver, extension] = names(driver);
  const bool restores_index = driver == Driver::shapefile && !file.companions.contains("shx");
  if (restores_index && !has_sound_records(file.bytes)) return;
  folder_ = fmt::format("/vsimem/furrow_{}", static_cast<const void*>(this));
  const std::string stem = folder_ + "/land", main = fmt::format("{}.{}", stem, extension);
  lay_out(main, file.bytes);
  if (driver == Driver::shapefile) {
    for (const auto& [name, bytes] : file.companions) lay_out(stem + "." + name, bytes);
  }
  const char* const drivers[] = {of_driver, nullptr};
  dataset_.reset(GDALDataset::Open(main.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers));
}

OpenLayers::~OpenLayers() {
  dataset_.reset();
  if (!folder_.empty())
    VSIRmdirRecursive(folder_.c_str());  // also what a driver wrote, like an index it restored
}

void OpenLayers::lay_out(const std::string& path, const std::string& bytes) {
  // GDAL only reads the buffer, through a door that is not const; the file outlives this object.
  auto* data = reinterpret_cast<GByte*>(const_cast<char*>(bytes.data()));
  VSILFILE* handle = VSIFileFromMemBuffer(path.c_str(), data, bytes.size(), FALSE);
  if (handle) VSIFCloseL(handle);
}

std::optional<Fault> read_vector_layers(const LandFile& file, Driver driver, Polygons& found) {
  const GdalScope gdal;
  if (driver == Driver::geojson) {
    if (auto fault = geojson_crs_fault(file.bytes)) return fault;
  }
  const OpenLayers open{file, driver};
  if (!open.dataset()) {
    return Fault{fmt::format("must be a sound {} file", names(driver).of_driver),
                 gdal.complaint().empty() ? "a damaged one" : gdal.complaint()};
  }
  for (OGRLayer* layer : open.dataset()->GetLayers()) {
    const OGRSpatialReference* crs = layer->GetSpatialRef();
    for (const auto& feature : *layer) {
      if (!feature->GetGeometryRef()) continue;
      if (!crs || crs->IsEmpty()) return no_crs(driver);
      found.add(*feature->GetGeometryRef(), tag(*feature, crs));
    }
  }
  return std::nullopt;
}

}  // namespace furrow::exchange
