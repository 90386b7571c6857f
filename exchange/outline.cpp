#include "exchange/outline.hpp"

#include "exchange/gdal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace furrow::exchange {

namespace {

using GeoRing = std::vector<GeoPoint>;
using Rings = std::vector<GeoRing>;  // the boundary first

constexpr double widest_deg = 2;  // of latitude, 220 km; more is no field, and no plane frame
constexpr double widest_m = 100'000;

// "WGS 84 (EPSG:4326), longitude first".
std::string described(const OGRSpatialReference* crs) {
  if (!crs) return "WGS84 without a CRS stated, longitude first";
  const char* const name = crs->GetName();
  const char* const code = crs->GetAuthorityCode(nullptr);
  std::string text = shown(name ? name : "a nameless CRS");
  if (code) text += fmt::format(" ({}:{})", crs->GetAuthorityName(nullptr), code);
  if (!crs->IsGeographic()) return text;
  const bool is_longitude_first = crs->GetDataAxisToSRSAxisMapping() == std::vector{2, 1};
  return text + (is_longitude_first ? ", longitude first" : ", latitude first");
}

Fault off_the_globe(double first, double second, const OGRSpatialReference* crs) {
  return {crs ? "coordinates must come to a place on the globe by their CRS"
              : "coordinates must be degrees on the globe, or have a CRS",
          fmt::format("{}, {} in {}", first, second, described(crs))};
}

Rings rings_of(const OGRPolygon& polygon) {
  Rings rings;
  for (const OGRLinearRing* source : polygon) {
    GeoRing& ring = rings.emplace_back();
    for (int i = 0; i < source->getNumPoints(); ++i) {
      ring.push_back({source->getX(i), source->getY(i)});
    }
  }
  return rings;
}

bool is_on_globe(GeoPoint p) { return std::abs(p.lon_deg) <= 540 && std::abs(p.lat_deg) <= 90; }

// A plane or globe of nobody's: a local grid, or the undefined CRS of a GeoPackage.
bool is_nowhere(const OGRSpatialReference& crs) {
  const char* const name = crs.GetName();
  return crs.IsLocal() || crs.IsGeocentric() ||
         (name && std::string_view{name}.starts_with("Undefined"));
}

std::optional<Fault> bring_to_wgs84(Rings& rings, const OGRSpatialReference& crs) {
  const OGRSpatialReference globe = wgs84();
  const std::unique_ptr<OGRCoordinateTransformation> transform{
      is_nowhere(crs) ? nullptr : OGRCreateCoordinateTransformation(&crs, &globe)};
  if (!transform) {
    return Fault{"CRS must be one that can be brought to WGS84", described(&crs)};
  }
  for (GeoRing& ring : rings) {
    for (GeoPoint& p : ring) {
      GeoPoint on = p;
      const bool is_finite = std::isfinite(p.lon_deg) && std::isfinite(p.lat_deg);
      const bool is_there = is_finite && transform->Transform(1, &on.lon_deg, &on.lat_deg);
      if (!is_there || !is_on_globe(on)) return off_the_globe(p.lon_deg, p.lat_deg, &crs);
      p = on;
    }
  }
  return std::nullopt;
}

// Longitudes within half a turn of the first vertex, so that none jumps at the antimeridian.
void unroll(Rings& rings) {
  const double first_deg = rings.front().front().lon_deg;
  for (GeoRing& ring : rings) {
    for (GeoPoint& p : ring) p.lon_deg = first_deg + std::remainder(p.lon_deg - first_deg, 360.0);
  }
}

std::optional<Fault> extent_fault(const GeoRing& boundary, const OGRSpatialReference* crs) {
  const auto [south, north] = std::minmax_element(
      boundary.begin(), boundary.end(), [](auto a, auto b) { return a.lat_deg < b.lat_deg; });
  const auto [west, east] = std::minmax_element(
      boundary.begin(), boundary.end(), [](auto a, auto b) { return a.lon_deg < b.lon_deg; });
  if (std::max(std::abs(south->lat_deg), std::abs(north->lat_deg)) > 85) {
    return Fault{"must lie within 85 degrees of the equator",
                 fmt::format("{:.4f} to {:.4f} degrees in {}", south->lat_deg, north->lat_deg,
                             described(crs))};
  }
  const double width_deg = (east->lon_deg - west->lon_deg) * std::cos(south->lat_deg * M_PI / 180);
  if (std::max(width_deg, north->lat_deg - south->lat_deg) > widest_deg) {
    return Fault{
        crs ? "must be at most 200 km wide" : "must be at most 200 km wide; bare metres need a CRS",
        fmt::format("{:.3g} x {:.3g} degrees in {}", east->lon_deg - west->lon_deg,
                    north->lat_deg - south->lat_deg, described(crs))};
  }
  return std::nullopt;
}

// The centroid, by the shoelace formula around the first vertex; degrees serve as a plane.
std::optional<Datum> centroid(const GeoRing& ring) {
  const GeoPoint o = ring.front();
  double twice_area = 0, lon = 0, lat = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GeoPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    const double ax = a.lon_deg - o.lon_deg, ay = a.lat_deg - o.lat_deg;
    const double bx = b.lon_deg - o.lon_deg, by = b.lat_deg - o.lat_deg;
    const double cross = ax * by - bx * ay;
    twice_area += cross;
    lon += (ax + bx) * cross;
    lat += (ay + by) * cross;
  }
  constexpr double a_hand_deg2 = 1e-12;  // 0.01 m2
  if (!(std::abs(twice_area) > a_hand_deg2)) return std::nullopt;
  const auto rounded = [](double deg) { return std::round(deg * 1e7) / 1e7; };
  return Datum{.lat_deg = rounded(o.lat_deg + lat / (3 * twice_area)),
               .lon_deg = rounded(std::remainder(o.lon_deg + lon / (3 * twice_area), 360.0))};
}

// In the field frame, without the repeated last vertex and other repetitions.
Ring ring_in(const LocalFrame& frame, const GeoRing& source) {
  Ring ring;
  for (const GeoPoint p : source) {
    const FieldPoint at = frame.to_field(p);
    if (ring.empty() || !(ring.back() == at)) ring.push_back(at);
  }
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

std::optional<Fault> content_fault(const Rings& rings, const OGRSpatialReference* crs) {
  if (rings.empty() || rings.front().empty()) return Fault{"boundary must have vertices", "none"};
  std::size_t vertices = 0;
  for (const GeoRing& ring : rings) vertices += ring.size();
  if (vertices > most_vertices) {
    return Fault{fmt::format("must have at most {} vertices", most_vertices),
                 std::to_string(vertices)};
  }
  for (const GeoRing& ring : rings) {
    const auto off = std::find_if_not(ring.begin(), ring.end(), is_on_globe);
    if (off != ring.end()) return off_the_globe(off->lon_deg, off->lat_deg, crs);
  }
  return std::nullopt;
}

std::optional<Fault> ring_fault(const Ring& ring, Datum datum) {
  if (ring.size() < 3) return Fault{"rings must have 3 vertices", std::to_string(ring.size())};
  for (const FieldPoint p : ring) {
    const double away_m = distance(at_m(0, 0), p).base();
    if (!(away_m <= widest_m)) {
      return Fault{
          "must reach at most 100 km from its centroid",
          fmt::format("{:.0f} km from {}, {}", away_m / 1000, datum.lon_deg, datum.lat_deg)};
    }
  }
  return std::nullopt;
}

Expected<Field, Fault> field_in(const LocalFrame& frame, const Rings& rings) {
  Field field;
  for (const GeoRing& source : rings) {
    Ring ring = ring_in(frame, source);
    if (auto fault = ring_fault(ring, frame.datum())) return Unexpected{*fault};
    if (&source == &rings.front()) {
      field.boundary = std::move(ring);
    } else {
      field.holes.push_back(std::move(ring));
    }
  }
  return field;
}

}  // namespace

Expected<Land, Fault> outline(const FoundPolygon& found) {
  const GdalScope quiet;
  Rings rings = rings_of(*found.polygon);
  std::erase_if(rings, [&](const GeoRing& ring) { return ring.empty(); });
  if (found.crs && !rings.empty()) {
    if (auto fault = bring_to_wgs84(rings, *found.crs)) return Unexpected{*fault};
  }
  if (auto fault = content_fault(rings, found.crs.get())) return Unexpected{*fault};
  unroll(rings);
  if (auto fault = extent_fault(rings.front(), found.crs.get())) return Unexpected{*fault};
  const auto datum = centroid(rings.front());
  if (!datum) return Unexpected{Fault{"boundary must enclose an area", "none"}};
  if (std::abs(datum->lat_deg) > 85) {
    return Unexpected{Fault{"boundary must not cross itself", "a centroid outside"}};
  }
  auto field = field_in(LocalFrame{*datum}, rings);
  if (!field) return Unexpected{field.error()};
  return Land{.field = std::move(*field),
              .datum = *datum,
              .stated_area = found.stated_area,
              .name = shown(found.name),
              .features = 0};
}

}  // namespace furrow::exchange
