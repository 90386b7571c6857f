#include "planner/coverage/swath/inset.hpp"

#include "planner/coverage/mend.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>

namespace furrow::planner {
namespace {

constexpr int obstacle_corners = 32;  // of the polygon around a round obstacle

PlanError invalid(const std::string& which, const std::string& why) {
  return {PlanFault::field_invalid, fmt::format("{}: {}", which, why)};
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
    taken.insert(taken.end(), hole->parts.begin(), hole->parts.end());
  }
  for (const Obstacle& obstacle : field.obstacles) {
    if (!std::isfinite(obstacle.center.x.base()) || !std::isfinite(obstacle.center.y.base()) ||
        !std::isfinite(obstacle.radius.base())) {
      return Unexpected{invalid("obstacle " + obstacle.id, "is not finite")};
    }
    if (!obstacle.outline.empty()) {
      const auto shape = mended(obstacle.outline, origin, "obstacle " + obstacle.id);
      if (!shape) return Unexpected{shape.error()};
      taken.insert(taken.end(), shape->parts.begin(), shape->parts.end());
    } else if (obstacle.radius > Length{}) {
      taken.push_back(disc(obstacle, origin));
    }
  }

  FieldLand made{origin, boundary->parts, {}, {}};
  if (!taken.empty()) {
    taken = united(taken);
    made.land = subtracted(boundary->parts, taken);
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
        PlanError{PlanFault::margin_too_wide,
                  fmt::format("a margin of {} m leaves nothing of a field of {:.1f} m2",
                              margin.base(), area_m2(made.land))}};
  }
  return made;
}

}  // namespace furrow::planner
