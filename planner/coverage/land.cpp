#include "planner/coverage/land.hpp"

#include <cmath>
#include <fmt/format.h>
#include <geos_c.h>
#include <memory>
#include <string>

namespace furrow::planner {
namespace {

// One GEOS context per call, so that calls share nothing. Its notices are dropped: what matters
// comes back as return values.
struct ContextDeleter {
  void operator()(GEOSContextHandle_HS* context) const { GEOS_finish_r(context); }
};
using Context = std::unique_ptr<GEOSContextHandle_HS, ContextDeleter>;

struct GeometryDeleter {
  GEOSContextHandle_t context;
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, GeometryDeleter>;

Geometry owned(const Context& context, GEOSGeometry* geometry) {
  require(geometry != nullptr, "GEOS builds a geometry from finite coordinates");
  return Geometry{geometry, GeometryDeleter{context.get()}};
}

PlanError invalid(std::string detail) { return {PlanFault::field_invalid, std::move(detail)}; }

bool is_finite(const Ring& ring) {
  for (const FieldPoint p : ring) {
    if (!std::isfinite(p.x.base()) || !std::isfinite(p.y.base())) return false;
  }
  return true;
}

GEOSGeometry* linear_ring(const Context& context, const Ring& ring) {
  const auto size = static_cast<unsigned>(ring.size()) + 1;
  GEOSCoordSequence* coordinates = GEOSCoordSeq_create_r(context.get(), size, 2);
  for (unsigned i = 0; i < size; ++i) {
    const FieldPoint p = ring[i % ring.size()];
    GEOSCoordSeq_setXY_r(context.get(), coordinates, i, p.x.base(), p.y.base());
  }
  GEOSGeometry* made = GEOSGeom_createLinearRing_r(context.get(), coordinates);
  require(made != nullptr, "GEOS builds a ring from three finite places");
  return made;
}

Geometry polygon(const Context& context, const Field& field) {
  std::vector<GEOSGeometry*> holes;
  for (const Ring& hole : field.holes) holes.push_back(linear_ring(context, hole));
  return owned(context,
               GEOSGeom_createPolygon_r(context.get(), linear_ring(context, field.boundary),
                                        holes.data(), static_cast<unsigned>(holes.size())));
}

// Nothing if the polygon is valid, else what breaks it and where.
std::string defect(const Context& context, const GEOSGeometry* shape) {
  char* reason = nullptr;
  GEOSGeometry* where = nullptr;
  const char valid = GEOSisValidDetail_r(context.get(), shape, 0, &reason, &where);
  std::string text;
  if (valid != 1) {
    text = reason ? reason : "not a polygon";
    double east_m = 0, north_m = 0;
    if (where && GEOSGeomGetX_r(context.get(), where, &east_m) == 1 &&
        GEOSGeomGetY_r(context.get(), where, &north_m) == 1) {
      text += fmt::format(" at ({:.3f}, {:.3f}) m", east_m, north_m);
    }
  }
  if (reason) GEOSFree_r(context.get(), reason);
  if (where) GEOSGeom_destroy_r(context.get(), where);
  return text;
}

Ring ring_of(const Context& context, const GEOSGeometry* linear) {
  const GEOSCoordSequence* coordinates = GEOSGeom_getCoordSeq_r(context.get(), linear);
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(context.get(), coordinates, &size);
  Ring ring;
  for (unsigned i = 0; i + 1 < size; ++i) {
    double east_m = 0, north_m = 0;
    GEOSCoordSeq_getXY_r(context.get(), coordinates, i, &east_m, &north_m);
    ring.push_back(at_m(east_m, north_m));
  }
  return ring;
}

std::vector<Ring> rings_of(const Context& context, const GEOSGeometry* shape) {
  std::vector<Ring> rings;
  for (int i = 0; i < GEOSGetNumGeometries_r(context.get(), shape); ++i) {
    const GEOSGeometry* part = GEOSGetGeometryN_r(context.get(), shape, i);
    if (GEOSisEmpty_r(context.get(), part) == 1) continue;
    rings.push_back(ring_of(context, GEOSGetExteriorRing_r(context.get(), part)));
    for (int h = 0; h < GEOSGetNumInteriorRings_r(context.get(), part); ++h) {
      rings.push_back(ring_of(context, GEOSGetInteriorRingN_r(context.get(), part, h)));
    }
  }
  return rings;
}

Geometry drawn_in(const Context& context, const GEOSGeometry* shape, double margin_m) {
  constexpr int segments_per_quarter = 8;  // unused by mitred corners
  constexpr double mitre_limit = 10.0;     // sharper corners than 12 degrees are cut off
  return owned(context, GEOSBufferWithStyle_r(context.get(), shape, -margin_m, segments_per_quarter,
                                              GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, mitre_limit));
}

}  // namespace

Expected<std::vector<Ring>, PlanError> land_rings(const Field& field, Length margin) {
  std::vector<Ring> rings{field.boundary};
  rings.insert(rings.end(), field.holes.begin(), field.holes.end());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const std::string which = i == 0 ? "boundary" : fmt::format("hole {}", i);
    if (rings[i].size() < 3) return Unexpected{invalid(which + " has fewer than 3 vertices")};
    if (!is_finite(rings[i]))
      return Unexpected{invalid(which + " has a vertex that is not finite")};
  }

  const Context context{GEOS_init_r()};
  const Geometry shape = polygon(context, field);
  if (const std::string why = defect(context, shape.get()); !why.empty()) {
    return Unexpected{invalid(why)};
  }
  if (margin <= Length{}) return rings;
  return rings_of(context, drawn_in(context, shape.get(), margin.base()).get());
}

}  // namespace furrow::planner
