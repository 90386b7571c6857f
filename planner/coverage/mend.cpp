#include "planner/coverage/mend.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace furrow::planner {
namespace {

constexpr double same_area = 1e-6;  // a mended ring may differ by this share
constexpr double dust = 1e-9;       // a part this small against the field comes from rounding

FieldPoint field_point(PointM p, PointM origin) { return at_m(p.x + origin.x, p.y + origin.y); }

PlanError invalid(const std::string& which, const std::string& why,
                  std::optional<FieldPoint> at = {}) {
  return {PlanFault::field_invalid, fmt::format("{}: {}", which, why), at};
}

// The ring around `origin`, each vertex once in a row.
Expected<RingM, PlanError> local_ring(const Ring& ring, PointM origin, const std::string& which) {
  if (ring.size() < 3) return Unexpected{invalid(which, "fewer than 3 vertices")};
  RingM local;
  for (const FieldPoint p : ring) {
    const PointM q = PointM{p.x.base(), p.y.base()} - origin;
    if (!std::isfinite(q.x) || !std::isfinite(q.y)) {
      return Unexpected{
          invalid(which, fmt::format("vertex {} is not finite", &p - ring.data() + 1))};
    }
    if (local.empty() || !(local.back() == q)) local.push_back(q);
  }
  while (local.size() > 1 && local.front() == local.back()) local.pop_back();
  return local;
}

PlanError without_area(const std::string& which, FieldPoint at) {
  return invalid(
      which, fmt::format("encloses no area at ({:.3f}, {:.3f}) m", at.x.base(), at.y.base()), at);
}

// Holes that meet the boundary or each other as polygons may not.
bool any_meet(const LandParts& boundary, const LandParts& holes) {
  LandPart whole{boundary.front().outer, {}};
  for (const LandPart& hole : holes) whole.holes.push_back(hole.outer);
  return boundary.size() > 1 || defect_in(whole).has_value();
}

Ring field_ring(const RingM& ring, PointM origin) {
  Ring made;
  made.reserve(ring.size());
  for (const PointM p : ring) made.push_back(field_point(p, origin));
  return made;
}

// The holes as they are within the boundary, apart from each other.
void set_apart(const LandParts& taken, const LandParts& boundary, PointM origin, SoundField& made) {
  const LandParts all = united(taken);
  const double least_m2 = dust * area_m2(boundary);
  for (const LandPart& hole : subtracted(all, subtracted(all, boundary))) {
    if (signed_area_m2(hole.outer) <= least_m2) continue;
    made.field.holes.push_back(field_ring(hole.outer, origin));
    for (const RingM& island : hole.holes) {
      if (std::abs(signed_area_m2(island)) <= least_m2) continue;
      made.remarks.push_back({std::nullopt, "has land that holes close in, which is left out",
                              field_point(island.front(), origin)});
    }
  }
}

}  // namespace

PointM origin_of(const Ring& ring) {
  PointM low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const FieldPoint p : ring) {
    low = {std::min(low.x, p.x.base()), std::min(low.y, p.y.base())};
    high = {std::max(high.x, p.x.base()), std::max(high.y, p.y.base())};
  }
  return {std::round((low.x + high.x) / 2), std::round((low.y + high.y) / 2)};
}

Expected<MendedRing, PlanError> mended(const Ring& ring, PointM origin, const std::string& which) {
  auto local = local_ring(ring, origin, which);
  if (!local) return Unexpected{local.error()};
  const FieldPoint first = field_point(local->front(), origin);
  if (local->size() < 3) return Unexpected{without_area(which, first)};

  const double signed_m2 = signed_area_m2(*local);
  const auto fault = defect_in({*local, {}});
  if (!fault) {
    if (signed_m2 == 0) return Unexpected{without_area(which, first)};
    if (signed_m2 < 0) std::reverse(local->begin(), local->end());
    return MendedRing{{{std::move(*local), {}}}, std::nullopt};
  }
  LandParts parts = even_odd(*local);
  const double enclosed_m2 = area_m2(parts);
  if (enclosed_m2 == 0) return Unexpected{without_area(which, first)};
  if (std::abs(enclosed_m2 - std::abs(signed_m2)) > same_area * enclosed_m2) {
    return Unexpected{invalid(which, text(*fault, origin), field_point(fault->at, origin))};
  }
  return MendedRing{std::move(parts), fault};
}

Expected<SoundField, PlanError> sound_field(const Field& field) {
  const PointM origin = field.boundary.empty() ? PointM{} : origin_of(field.boundary);
  const auto boundary = mended(field.boundary, origin, "boundary");
  if (!boundary) return Unexpected{boundary.error()};
  SoundField made{{field.boundary, {}, field.obstacles}, {}};
  const auto remark = [&](std::optional<std::size_t> hole, std::string what, PointM at) {
    made.remarks.push_back({hole, std::move(what), field_point(at, origin)});
  };
  const std::string mends = "crosses or touches itself and is mended";
  if (boundary->defect) remark({}, mends, boundary->defect->at);

  LandParts taken;
  std::vector<Ring> kept;
  for (std::size_t i = 0; i < field.holes.size(); ++i) {
    const auto hole = mended(field.holes[i], origin, fmt::format("hole {}", i + 1));
    if (!hole) return Unexpected{hole.error()};
    if (hole->defect) remark(i, mends, hole->defect->at);
    const double beyond_m2 = area_m2(subtracted(hole->parts, boundary->parts));
    if (beyond_m2 >= (1 - dust) * area_m2(hole->parts)) {
      remark(i, "lies outside the boundary and is left out", hole->parts.front().outer.front());
      continue;
    }
    kept.push_back(field.holes[i]);
    taken.insert(taken.end(), hole->parts.begin(), hole->parts.end());
  }
  if (area_m2(subtracted(boundary->parts, united(taken))) <= dust * area_m2(boundary->parts)) {
    return Unexpected{PlanError{PlanFault::nothing_to_spray, "holes cover the whole field"}};
  }
  if (any_meet(boundary->parts, taken)) {
    set_apart(taken, boundary->parts, origin, made);
  } else {
    made.field.holes = std::move(kept);
  }
  return made;
}

}  // namespace furrow::planner
