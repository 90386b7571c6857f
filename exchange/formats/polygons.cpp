#include "exchange/formats/polygons.hpp"

#include <cpl_string.h>

#include <charconv>
#include <cmath>
#include <vector>

namespace furrow::exchange {

namespace {

void collect(const OGRGeometry& geometry, std::vector<const OGRPolygon*>& parts) {
  if (const auto* polygon = dynamic_cast<const OGRPolygon*>(&geometry)) {
    if (!polygon->IsEmpty()) parts.push_back(polygon);
  } else if (const auto* collection = dynamic_cast<const OGRGeometryCollection*>(&geometry)) {
    for (const OGRGeometry* part : *collection) collect(*part, parts);
  }
}

bool has_longitude_first(const OGRSpatialReference* crs) {
  return !crs || (crs->IsGeographic() && crs->GetDataAxisToSRSAxisMapping() == std::vector{2, 1});
}

// RFC 7946 cuts what crosses the antimeridian in two; here the parts become one again.
std::unique_ptr<OGRGeometry> joined_at_antimeridian(const OGRMultiPolygon& parts) {
  OGRMultiPolygon unrolled{parts};
  for (OGRPolygon* part : unrolled) {
    OGREnvelope box;
    part->getEnvelope(&box);
    if (box.MinX >= 0) continue;
    for (OGRLinearRing* ring : *part) {
      for (int i = 0; i < ring->getNumPoints(); ++i) {
        ring->setPoint(i, ring->getX(i) + 360, ring->getY(i));
      }
    }
  }
  return std::unique_ptr<OGRGeometry>{unrolled.UnionCascaded()};
}

bool is_cut_at_antimeridian(const OGRGeometry& geometry, const OGRSpatialReference* crs) {
  if (wkbFlatten(geometry.getGeometryType()) != wkbMultiPolygon || !has_longitude_first(crs)) {
    return false;
  }
  OGREnvelope box;
  geometry.getEnvelope(&box);
  return box.MinX == -180 && box.MaxX == 180;
}

}  // namespace

void Polygons::add(const OGRGeometry& geometry, const Tag& tag) {
  std::unique_ptr<OGRGeometry> flat{geometry.getLinearGeometry()};
  if (!flat) return;
  flat->flattenTo2D();
  if (is_cut_at_antimeridian(*flat, tag.crs)) {
    if (auto joined = joined_at_antimeridian(*flat->toMultiPolygon())) flat = std::move(joined);
  }
  std::vector<const OGRPolygon*> parts;
  collect(*flat, parts);
  if (parts.empty()) ++others_;
  Tag of_part = tag;
  if (parts.size() > 1) of_part.stated_area.reset();
  for (const OGRPolygon* part : parts) take(*part, of_part);
}

void Polygons::take(const OGRPolygon& polygon, const Tag& tag) {
  constexpr std::size_t most_names = 20;
  if (names_.size() < most_names) names_.push_back(tag.name);
  if (count_++ != wanted_) return;
  chosen_ = FoundPolygon{.polygon = std::make_unique<OGRPolygon>(polygon),
                         .crs = tag.crs ? std::make_unique<OGRSpatialReference>(*tag.crs) : nullptr,
                         .name = tag.name,
                         .stated_area = tag.stated_area};
}

std::optional<Area> stated_area(std::string_view key, std::string_view value) {
  const auto amount = number(value);
  if (!amount || *amount <= 0) return std::nullopt;
  const std::string name{key};
  for (const char* known : {"area_m2", "area_sqm", "net_area_m2"}) {
    if (EQUAL(name.c_str(), known)) return square_metres(*amount);
  }
  for (const char* known : {"area_ha", "net_area_ha", "hectares"}) {
    if (EQUAL(name.c_str(), known)) return hectares(*amount);
  }
  return std::nullopt;
}

std::optional<double> number(std::string_view text) {
  double value{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

}  // namespace furrow::exchange
