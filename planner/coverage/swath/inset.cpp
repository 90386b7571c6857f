#include "planner/coverage/swath/inset.hpp"

#include "planner/coverage/geos.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>

namespace furrow::planner {
namespace {

constexpr double same_area = 1e-6;    // a mended ring may differ by this share
constexpr int obstacle_corners = 32;  // of the polygon around a round obstacle

// Whole metres, so that short decimal coordinates stay exact after the shift.
PointM origin_of(const Ring& ring) {
  PointM low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const FieldPoint p : ring) {
    low = {std::min(low.x, p.x.base()), std::min(low.y, p.y.base())};
    high = {std::max(high.x, p.x.base()), std::max(high.y, p.y.base())};
  }
  return {std::round((low.x + high.x) / 2), std::round((low.y + high.y) / 2)};
}

PlanError invalid(const std::string& which, const std::string& why) {
  return {PlanFault::field_invalid, fmt::format("{}: {}", which, why)};
}

Expected<LandParts, PlanError> mended(const Ring& ring, PointM origin, const std::string& which) {
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
  const auto no_area = [&] {
    return Unexpected{invalid(which, fmt::format("encloses no area at ({:.3f}, {:.3f}) m",
                                                 local[0].x + origin.x, local[0].y + origin.y))};
  };
  if (local.size() < 3) return no_area();

  const double signed_m2 = signed_area_m2(local);
  const std::string why = defect({local, {}}, origin);
  if (why.empty()) {
    if (signed_m2 == 0) return no_area();
    if (signed_m2 < 0) std::reverse(local.begin(), local.end());
    return LandParts{{std::move(local), {}}};
  }
  LandParts parts = even_odd(local);
  const double enclosed_m2 = area_m2(parts);
  if (enclosed_m2 == 0) return no_area();
  if (std::abs(enclosed_m2 - std::abs(signed_m2)) > same_area * enclosed_m2) {
    return Unexpected{invalid(which, why)};
  }
  return parts;
}

// Outside the circle everywhere, so that keeping out of it keeps out of the obstacle.
LandPart disc(const Obstacle& obstacle, PointM origin) {
  const PointM center = PointM{obstacle.center.x.base(), obstacle.center.y.base()} - origin;
  const double step = 2 * std::numbers::pi / obstacle_corners;
  const double radius_m = obstacle.radius.base() / std::cos(step / 2);
  LandPart made;
  for (int i = 0; i < obstacle_corners; ++i) {
    made.outer.push_back(center + radius_m * PointM{std::cos(i * step), std::sin(i * step)});
  }
  return made;
}

// Parts this thin come from rounding, not from land.
void drop_dust(LandParts& parts) {
  const double least_m2 = 1e-9 * area_m2(parts);
  std::erase_if(parts, [&](const LandPart& part) { return area_m2(part) <= least_m2; });
  for (LandPart& part : parts) {
    std::erase_if(part.holes,
                  [&](const RingM& hole) { return std::abs(signed_area_m2(hole)) <= least_m2; });
  }
}

}  // namespace

Expected<FieldLand, PlanError> field_land(const Field& field, Length margin, Length hole_buffer) {
  require(margin >= Length{} && hole_buffer >= Length{}, "margins are at least 0");
  const PointM origin = field.boundary.empty() ? PointM{} : origin_of(field.boundary);
  const auto boundary = mended(field.boundary, origin, "boundary");
  if (!boundary) return Unexpected{boundary.error()};

  LandParts taken;
  for (std::size_t i = 0; i < field.holes.size(); ++i) {
    const auto hole = mended(field.holes[i], origin, fmt::format("hole {}", i + 1));
    if (!hole) return Unexpected{hole.error()};
    taken.insert(taken.end(), hole->begin(), hole->end());
  }
  for (const Obstacle& obstacle : field.obstacles) {
    if (!std::isfinite(obstacle.center.x.base()) || !std::isfinite(obstacle.center.y.base()) ||
        !std::isfinite(obstacle.radius.base())) {
      return Unexpected{invalid("obstacle " + obstacle.id, "is not finite")};
    }
    if (!obstacle.outline.empty()) {
      const auto shape = mended(obstacle.outline, origin, "obstacle " + obstacle.id);
      if (!shape) return Unexpected{shape.error()};
      taken.insert(taken.end(), shape->begin(), shape->end());
    } else if (obstacle.radius > Length{}) {
      taken.push_back(disc(obstacle, origin));
    }
  }

  FieldLand made{origin, *boundary, {}, {}};
  if (!taken.empty()) {
    taken = united(taken);
    made.land = subtracted(*boundary, taken);
  }
  drop_dust(made.land);
  if (made.land.empty()) {
    return Unexpected{PlanError{PlanFault::nothing_to_spray, "holes cover the whole field"}};
  }
  made.flight = offset(made.land, -margin.base());
  made.taken = offset(taken, (margin + hole_buffer).base());
  if (!taken.empty() && hole_buffer > Length{}) made.flight = subtracted(made.flight, made.taken);
  drop_dust(made.flight);
  if (made.flight.empty()) {
    return Unexpected{
        PlanError{PlanFault::nothing_to_spray,
                  fmt::format("a margin of {} m leaves nothing of a field of {:.1f} m2",
                              margin.base(), area_m2(made.land))}};
  }
  return made;
}

}  // namespace furrow::planner
