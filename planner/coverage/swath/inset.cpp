#include "planner/coverage/swath/inset.hpp"

#include "planner/coverage/mend.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <numeric>
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

// Of each part, the first of those that it may meet, by their boxes.
std::vector<std::size_t> neighbourhoods(const LandParts& parts) {
  std::vector<BoxM> boxes;
  boxes.reserve(parts.size());
  for (const LandPart& part : parts) boxes.push_back(box_of(part.outer));
  std::vector<std::size_t> by_x(parts.size()), head(parts.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::iota(head.begin(), head.end(), std::size_t{0});
  std::stable_sort(by_x.begin(), by_x.end(),
                   [&](std::size_t a, std::size_t b) { return boxes[a].low.x < boxes[b].low.x; });
  const auto head_of = [&](std::size_t i) {
    while (head[i] != i) i = head[i] = head[head[i]];
    return i;
  };
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    const BoxM& one = boxes[by_x[i]];
    for (std::size_t k = i + 1; k < by_x.size() && boxes[by_x[k]].low.x <= one.high.x; ++k) {
      const BoxM& other = boxes[by_x[k]];
      if (other.low.y > one.high.y || one.low.y > other.high.y) continue;
      const std::size_t x = head_of(by_x[i]), y = head_of(by_x[k]);
      head[std::max(x, y)] = std::min(x, y);
    }
  }
  for (std::size_t i = 0; i < head.size(); ++i) head[i] = head_of(i);
  return head;
}

// The union, neighbourhood by neighbourhood: most trees stand alone, and one of all is long work.
LandParts joined(LandParts some, const LandParts& more) {
  some.insert(some.end(), more.begin(), more.end());
  const std::vector<std::size_t> head = neighbourhoods(some);
  std::map<std::size_t, LandParts> groups;
  for (std::size_t i = 0; i < some.size(); ++i) groups[head[i]].push_back(std::move(some[i]));
  LandParts made;
  for (auto& [first, group] : groups) {
    if (group.size() > 1) group = united(group);
    for (LandPart& part : group) made.push_back(std::move(part));
  }
  return made;
}

LandParts grown(const LandParts& parts, Length by) {
  return by > Length{} ? joined(offset(parts, by.base()), {}) : parts;
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

Expected<LandParts, PlanError> obstacle_parts(const std::vector<Obstacle>& obstacles,
                                              PointM origin) {
  LandParts made;
  for (const Obstacle& obstacle : obstacles) {
    if (!std::isfinite(obstacle.center.x.base()) || !std::isfinite(obstacle.center.y.base()) ||
        !std::isfinite(obstacle.radius.base())) {
      return Unexpected{invalid("obstacle " + obstacle.id, "is not finite")};
    }
    if (!obstacle.outline.empty()) {
      const auto shape = mended(obstacle.outline, origin, "obstacle " + obstacle.id);
      if (!shape) return Unexpected{shape.error()};
      made.insert(made.end(), shape->parts.begin(), shape->parts.end());
    } else if (obstacle.radius > Length{}) {
      made.push_back(disc(obstacle, origin));
    }
  }
  return made;
}

}  // namespace

Expected<FieldLand, PlanError> field_land(const Field& field, Length margin, Length hole_buffer,
                                          Length safety) {
  require(margin >= Length{} && hole_buffer >= Length{} && safety >= Length{},
          "margins are at least 0");
  const PointM origin = field.boundary.empty() ? PointM{} : origin_of(field.boundary);
  const auto boundary = mended(field.boundary, origin, "boundary");
  if (!boundary) return Unexpected{boundary.error()};

  LandParts holes;
  for (std::size_t i = 0; i < field.holes.size(); ++i) {
    const auto hole = mended(field.holes[i], origin, fmt::format("hole {}", i + 1));
    if (!hole) return Unexpected{hole.error()};
    holes.insert(holes.end(), hole->parts.begin(), hole->parts.end());
  }
  auto obstacles = obstacle_parts(field.obstacles, origin);
  if (!obstacles) return Unexpected{obstacles.error()};

  FieldLand made{origin, boundary->parts, {}, {}};
  const LandParts taken = joined(holes, *obstacles);
  if (!taken.empty()) made.land = subtracted(boundary->parts, taken);
  drop_dust(made.land);
  if (made.land.empty()) {
    return Unexpected{PlanError{PlanFault::nothing_to_spray, "holes cover the whole field"}};
  }
  made.flight = offset(made.land, -margin.base());
  const Length from_holes = margin + hole_buffer, from_obstacles = std::max(from_holes, safety);
  made.taken = from_obstacles == from_holes ? grown(taken, from_holes)
                                            : joined(grown(joined(holes, {}), from_holes),
                                                     grown(joined(*obstacles, {}), from_obstacles));
  if (from_obstacles > margin) made.flight = subtracted(made.flight, made.taken);
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
