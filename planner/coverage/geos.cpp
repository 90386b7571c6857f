#include "planner/coverage/geos.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <geos_c.h>
#include <memory>
#include <numbers>

namespace furrow::planner {
namespace {

// One context per call, so that calls share nothing. Its notices are dropped: what matters comes
// back as return values.
class Session {
 public:
  struct Free {
    GEOSContextHandle_t context;
    void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
  };
  using Owned = std::unique_ptr<GEOSGeometry, Free>;

  Session() : context_{GEOS_init_r()} {}
  ~Session() { GEOS_finish_r(context_); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  GEOSContextHandle_t context() const { return context_; }
  Owned owned(GEOSGeometry* geometry) const { return Owned{geometry, Free{context_}}; }

  GEOSCoordSequence* sequence(const PathM& path, bool closed) const {
    const std::size_t size = path.size() + (closed ? 1 : 0);
    GEOSCoordSequence* made = GEOSCoordSeq_create_r(context_, static_cast<unsigned>(size), 2);
    for (unsigned i = 0; i < size; ++i) {
      const PointM p = path[i % path.size()];
      GEOSCoordSeq_setXY_r(context_, made, i, p.x, p.y);
    }
    return made;
  }

  GEOSGeometry* polygon(const LandPart& part) const {
    std::vector<GEOSGeometry*> holes;
    for (const RingM& hole : part.holes) {
      holes.push_back(GEOSGeom_createLinearRing_r(context_, sequence(hole, true)));
    }
    return GEOSGeom_createPolygon_r(
        context_, GEOSGeom_createLinearRing_r(context_, sequence(part.outer, true)), holes.data(),
        static_cast<unsigned>(holes.size()));
  }

  Owned polygons(const LandParts& parts) const {
    std::vector<GEOSGeometry*> members;
    for (const LandPart& part : parts) members.push_back(polygon(part));
    return owned(GEOSGeom_createCollection_r(context_, GEOS_MULTIPOLYGON, members.data(),
                                             static_cast<unsigned>(members.size())));
  }

  LandParts parts_of(const GEOSGeometry* shape) const {
    require(shape != nullptr, "GEOS answers for finite coordinates");
    LandParts parts;
    collect(shape, parts);
    return parts;
  }

 private:
  RingM ring_of(const GEOSGeometry* linear, bool counter_clockwise) const {
    const GEOSCoordSequence* coordinates = GEOSGeom_getCoordSeq_r(context_, linear);
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(context_, coordinates, &size);
    RingM ring;
    for (unsigned i = 0; i + 1 < size; ++i) {
      PointM p{};
      GEOSCoordSeq_getXY_r(context_, coordinates, i, &p.x, &p.y);
      if (ring.empty() || !(ring.back() == p)) ring.push_back(p);
    }
    if ((signed_area_m2(ring) > 0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
    return ring;
  }

  void collect(const GEOSGeometry* shape, LandParts& parts) const {
    if (GEOSisEmpty_r(context_, shape) == 1) return;
    if (GEOSGeomTypeId_r(context_, shape) == GEOS_POLYGON) {
      LandPart part{ring_of(GEOSGetExteriorRing_r(context_, shape), true), {}};
      for (int h = 0; h < GEOSGetNumInteriorRings_r(context_, shape); ++h) {
        part.holes.push_back(ring_of(GEOSGetInteriorRingN_r(context_, shape, h), false));
      }
      parts.push_back(std::move(part));
      return;
    }
    const int members = GEOSGetNumGeometries_r(context_, shape);
    if (members == 1 && GEOSGetGeometryN_r(context_, shape, 0) == shape) return;  // point or line
    for (int i = 0; i < members; ++i) collect(GEOSGetGeometryN_r(context_, shape, i), parts);
  }

  GEOSContextHandle_t context_;
};

// Rows that share an edge up to rounding untangle reliably only on a grid: without one, GEOS 3.11
// now and then loses a row. A thousand of these steps are a tenth of a millimetre.
constexpr double overlay_grid_m = 1e-7;

std::vector<BoxM> boxes_of(const LandParts& parts) {
  std::vector<BoxM> boxes;
  boxes.reserve(parts.size());
  for (const LandPart& part : parts) boxes.push_back(box_of(part.outer));
  return boxes;
}

bool meets_any(const BoxM& box, const std::vector<BoxM>& others) {
  return std::any_of(others.begin(), others.end(),
                     [&](const BoxM& other) { return overlap(box, other); });
}

// Whether part `i` of `taken` is near no other part and near no edge of `land`. It lies whole
// inside or whole outside then, and taking it away is no matter for GEOS, whose time is by the
// corner.
bool is_lone(std::size_t i, const LandParts& taken, const std::vector<BoxM>& of_taken,
             const LandParts& land) {
  if (!taken[i].holes.empty()) return false;
  const BoxM box = grown(of_taken[i], 1e3 * overlay_grid_m);
  for (std::size_t j = 0; j < taken.size(); ++j) {
    if (j != i && overlap(box, of_taken[j])) return false;
  }
  bool is_near = false;
  for (const LandPart& part : land) {
    each_edge(part, [&](PointM a, PointM b) { is_near = is_near || overlap(box, box_of(a, b)); });
  }
  return !is_near;
}

// Makes `ring`, which no edge of `land` is near, a hole of the part it lies in, if any.
void add_hole(LandParts& land, const RingM& ring) {
  for (LandPart& part : land) {
    bool is_within = false;
    each_edge(part, [&](PointM a, PointM b) { is_within ^= is_left_of(ring.front(), a, b); });
    if (!is_within) continue;
    part.holes.emplace_back(ring.rbegin(), ring.rend());
    return;
  }
}

LandParts difference(const LandParts& land, const LandParts& taken) {
  if (taken.empty()) return land;
  const Session geos;
  const auto a = geos.polygons(land);
  const auto b = geos.polygons(taken);
  return geos.parts_of(
      geos.owned(GEOSDifferencePrec_r(geos.context(), a.get(), b.get(), overlay_grid_m)).get());
}

}  // namespace

std::optional<Defect> defect_in(const LandPart& part) {
  const Session geos;
  const auto shape = geos.owned(geos.polygon(part));
  char* reason = nullptr;
  GEOSGeometry* where = nullptr;
  std::optional<Defect> defect;
  if (GEOSisValidDetail_r(geos.context(), shape.get(), 0, &reason, &where) != 1) {
    defect = Defect{reason ? reason : "not a polygon", part.outer.front()};
    PointM p{};
    if (where && GEOSGeomGetX_r(geos.context(), where, &p.x) == 1 &&
        GEOSGeomGetY_r(geos.context(), where, &p.y) == 1) {
      defect->at = p;
    }
  }
  if (reason) GEOSFree_r(geos.context(), reason);
  if (where) GEOSGeom_destroy_r(geos.context(), where);
  return defect;
}

std::string text(const Defect& defect, PointM origin) {
  return fmt::format("{} at ({:.3f}, {:.3f}) m", defect.why, defect.at.x + origin.x,
                     defect.at.y + origin.y);
}

LandParts even_odd(const RingM& ring) {
  const Session geos;
  const auto shape = geos.owned(geos.polygon({ring, {}}));
  return geos.parts_of(geos.owned(GEOSMakeValid_r(geos.context(), shape.get())).get());
}

LandParts united(const LandParts& parts) {
  if (parts.size() < 2) return parts;
  const Session geos;
  const auto shape = geos.polygons(parts);
  const auto made = geos.owned(GEOSUnaryUnionPrec_r(geos.context(), shape.get(), overlay_grid_m));
  return geos.parts_of(made.get());
}

LandParts subtracted(const LandParts& land, const LandParts& taken) {
  const auto of_taken = boxes_of(taken);
  LandParts touched, made;
  for (const LandPart& part : land) {
    (meets_any(box_of(part.outer), of_taken) ? touched : made).push_back(part);
  }
  if (touched.empty()) return made;
  LandParts lone, rest;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    (is_lone(i, taken, of_taken, touched) ? lone : rest).push_back(taken[i]);
  }
  touched = difference(touched, rest);
  for (const LandPart& part : lone) add_hole(touched, part.outer);
  std::move(touched.begin(), touched.end(), std::back_inserter(made));
  return made;
}

LandParts offset(const LandParts& land, double distance_m) {
  if (land.empty() || distance_m == 0) return land;
  constexpr int segments_per_quarter = 8;
  constexpr double mitre_limit = 10.0;  // sharper corners than 12 degrees are cut off
  const Session geos;
  const auto shape = geos.polygons(land);
  const auto with = [&](int join, double away_m) {
    return geos.owned(GEOSBufferWithStyle_r(geos.context(), shape.get(), away_m,
                                            segments_per_quarter, GEOSBUF_CAP_FLAT, join,
                                            mitre_limit));
  };
  auto made = with(GEOSBUF_JOIN_MITRE, distance_m);
  // GEOS 3.11 loses a hole now and then where a neck is nearly nothing wide. The outcome is then
  // invalid, and that of round corners has proved right. Their chords keep the distance too.
  if (made && GEOSisValid_r(geos.context(), made.get()) != 1) {
    const double chord = std::cos(std::numbers::pi / 4 / segments_per_quarter);
    made = with(GEOSBUF_JOIN_ROUND, distance_m / chord);
    require(made && GEOSisValid_r(geos.context(), made.get()) == 1, "GEOS widens sound land");
  }
  return geos.parts_of(made.get());
}

LandParts widened(const PathM& path, double half_width_m) {
  constexpr int segments_per_quarter = 8;
  constexpr double mitre_limit = 1.0;  // unused by round corners
  const Session geos;
  const auto line =
      geos.owned(GEOSGeom_createLineString_r(geos.context(), geos.sequence(path, false)));
  return geos.parts_of(geos.owned(GEOSBufferWithStyle_r(geos.context(), line.get(), half_width_m,
                                                        segments_per_quarter, GEOSBUF_CAP_FLAT,
                                                        GEOSBUF_JOIN_ROUND, mitre_limit))
                           .get());
}

LandParts faces(const std::vector<PathM>& lines) {
  const Session geos;
  std::vector<GEOSGeometry*> members;
  members.reserve(lines.size());
  for (const PathM& line : lines) {
    members.push_back(GEOSGeom_createLineString_r(geos.context(), geos.sequence(line, false)));
  }
  const auto all = geos.owned(GEOSGeom_createCollection_r(
      geos.context(), GEOS_MULTILINESTRING, members.data(), static_cast<unsigned>(members.size())));
  const auto noded = geos.owned(GEOSUnaryUnion_r(geos.context(), all.get()));
  require(noded != nullptr, "GEOS nodes finite lines");
  const GEOSGeometry* const input[] = {noded.get()};
  return geos.parts_of(geos.owned(GEOSPolygonize_r(geos.context(), input, 1)).get());
}

PointM inner_place(const LandPart& part) {
  const Session geos;
  const auto shape = geos.owned(geos.polygon(part));
  const auto point = geos.owned(GEOSPointOnSurface_r(geos.context(), shape.get()));
  require(point != nullptr, "a polygon has a place inside");
  PointM p{};
  GEOSGeomGetX_r(geos.context(), point.get(), &p.x);
  GEOSGeomGetY_r(geos.context(), point.get(), &p.y);
  return p;
}

double length_outside_m(const std::vector<PathM>& paths, const LandParts& land) {
  const Session geos;
  const auto shape = geos.polygons(land);
  const GEOSPreparedGeometry* prepared = GEOSPrepare_r(geos.context(), shape.get());
  double sum = 0;
  for (const PathM& path : paths) {
    // Leg by leg: a way flown twice counts twice.
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (path[i] == path[i - 1]) continue;
      const auto leg = geos.owned(GEOSGeom_createLineString_r(
          geos.context(), geos.sequence({path[i - 1], path[i]}, false)));
      if (GEOSPreparedCovers_r(geos.context(), prepared, leg.get()) == 1) continue;
      const auto outside = geos.owned(GEOSDifference_r(geos.context(), leg.get(), shape.get()));
      require(outside != nullptr, "GEOS answers for finite coordinates");
      double length = 0;
      GEOSLength_r(geos.context(), outside.get(), &length);
      sum += length;
    }
  }
  GEOSPreparedGeom_destroy_r(geos.context(), prepared);
  return sum;
}

}  // namespace furrow::planner
