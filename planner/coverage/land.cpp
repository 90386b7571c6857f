#include "planner/coverage/land.hpp"

#include "planner/coverage/geos.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string>

namespace furrow::planner {
namespace {

PlanError invalid(std::string detail) { return {PlanFault::field_invalid, std::move(detail)}; }

bool is_finite(const Ring& ring) {
  for (const FieldPoint p : ring) {
    if (!std::isfinite(p.x.base()) || !std::isfinite(p.y.base())) return false;
  }
  return true;
}

RingM plane_ring(const Ring& ring) {
  RingM made;
  for (const FieldPoint p : ring) made.push_back({p.x.base(), p.y.base()});
  return made;
}

Ring field_ring(const RingM& ring) {
  Ring made;
  for (const PointM p : ring) made.push_back(at_m(p.x, p.y));
  return made;
}

std::vector<Ring> rings_of(const LandParts& parts) {
  std::vector<Ring> rings;
  for (const LandPart& part : parts) {
    rings.push_back(field_ring(part.outer));
    for (const RingM& hole : part.holes) rings.push_back(field_ring(hole));
  }
  return rings;
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

  LandParts taken;
  LandPart land{plane_ring(field.boundary), {}};
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const RingM ring = plane_ring(rings[i]);
    if (const auto fault = defect_in({ring, {}})) {
      return Unexpected{PlanError{PlanFault::field_invalid, text(*fault, {0, 0}),
                                  at_m(fault->at.x, fault->at.y)}};
    }
    if (i == 0) continue;
    land.holes.push_back(ring);
    taken.push_back({ring, {}});
  }
  // Where holes touch the boundary or each other, their rings make no polygon as they are.
  const bool is_sound = !defect_in(land);
  if (is_sound && margin <= Length{}) return rings;
  const LandParts parts =
      is_sound ? LandParts{land} : subtracted({{land.outer, {}}}, united(taken));
  return rings_of(offset(parts, -margin.base()));
}

}  // namespace furrow::planner
