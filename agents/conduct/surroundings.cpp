#include "agents/conduct/surroundings.hpp"

#include "agents/xy.hpp"
#include "planner/avoidance/clear_way.hpp"
#include "planner/avoidance/onboard.hpp"

#include <algorithm>
#include <utility>

namespace furrow::agents {
namespace {

using Bends = std::vector<FieldPoint>;

constexpr double tight_turn_m = 0.01;  // on the spot
constexpr double same_place_m = 1e-6;
constexpr double way_out_m = 0.05;  // beyond the clearance
constexpr int most_crowds = 100;    // on one leg

// From one crowd of obstacles to the next.
std::optional<Bends> bends(FieldPoint from, FieldPoint to, Length swath, const planner::Room& room,
                           Length turn_radius) {
  const Xy ahead = xy_m(to) - xy_m(from);
  if (norm(ahead) < same_place_m) return std::nullopt;  // and that place is too near
  planner::OnboardLine line{{from, std::atan2(ahead.y, ahead.x)}, from, to, swath};
  Bends all;
  for (int i = 0; i < most_crowds; ++i) {
    const auto detour = planner::onboard_detour(line, room, turn_radius);
    if (!detour && detour.error() == planner::NoDetour::nothing_ahead) return all;
    if (!detour || detour->way.size() < 2) return std::nullopt;  // or it leads nowhere
    all.insert(all.end(), detour->way.begin() + 1, detour->way.end());
    line.pose.at = all.back();
  }
  return std::nullopt;
}

planner::PointM plane(FieldPoint p) { return {p.x.base(), p.y.base()}; }

// By a way with corners.
std::optional<Bends> corners(FieldPoint from, FieldPoint to, const planner::Room& room) {
  const auto way = planner::clear_way(plane(from), plane(to), room);
  if (!way) return std::nullopt;
  Bends all;
  for (std::size_t i = 1; i + 1 < way->size(); ++i) all.push_back(at_m((*way)[i].x, (*way)[i].y));
  return all;
}

}  // namespace

Surroundings::Surroundings(AvoidanceRule rule)
    : rule_{std::move(rule)}, room_{rule_.planned}, open_room_{rule_.beyond} {}

double Surroundings::kept_m(const SeenObstacle& o) const {
  return (o.radius + rule_.clearance).base();
}

bool Surroundings::learn(const SeenObstacle& obstacle) {
  if (std::find(seen_.begin(), seen_.end(), obstacle) != seen_.end()) return false;
  seen_.push_back(obstacle);
  const Xy at = xy_m(obstacle.center);
  room_ = room_.with({{{at.x, at.y}, kept_m(obstacle)}});
  open_room_ = open_room_.with({{{at.x, at.y}, kept_m(obstacle)}});
  return true;
}

bool Surroundings::is_within(FieldPoint place, Length more) const {
  return std::any_of(seen_.begin(), seen_.end(), [&](const SeenObstacle& o) {
    return distance(place, o.center).base() < kept_m(o) + more.base();
  });
}

std::optional<double> Surroundings::clear_m(FieldPoint from, FieldPoint to) const {
  const Xy way = xy_m(to) - xy_m(from);
  const double length = norm(way);
  std::optional<double> clear;
  for (const SeenObstacle& o : seen_) {
    const Xy there = xy_m(o.center) - xy_m(from);
    const double kept = kept_m(o);
    const double along = length > 0.0 ? dot(there, way) / length : 0.0;
    const double beside_square = dot(there, there) - along * along;
    if (beside_square >= kept * kept) continue;
    const double half = std::sqrt(kept * kept - beside_square);
    if (along + half <= 0.0 || along - half >= length) continue;
    clear = std::min(clear.value_or(length), std::max(0.0, along - half));
  }
  return clear;
}

std::optional<Bends> Surroundings::strip_bends(FieldPoint from, FieldPoint to, Length swath) const {
  if (!clear_m(from, to)) return Bends{};
  return bends(from, to, swath, room_, rule_.turn_radius);
}

// The nearest place clear of the obstacle that is too near, if one is.
std::optional<FieldPoint> Surroundings::way_out(FieldPoint from) const {
  const auto near = std::find_if(seen_.begin(), seen_.end(), [&](const SeenObstacle& o) {
    return distance(from, o.center).base() < kept_m(o);
  });
  if (near == seen_.end()) return std::nullopt;
  const Xy away = xy_m(from) - xy_m(near->center);
  const double far_m = norm(away);
  const Xy outward = far_m > 0.0 ? (1.0 / far_m) * away : Xy{0.0, 1.0};
  return field_point(xy_m(near->center) + (kept_m(*near) + way_out_m) * outward);
}

std::optional<FerryBends> Surroundings::ferry_bends(FieldPoint from, FieldPoint to) const {
  FerryBends made;
  if (!clear_m(from, to)) return made;
  if (is_too_near(to)) return std::nullopt;
  if (const auto out = way_out(from)) {
    from = *out;
    made.bends.push_back(from);
    if (!clear_m(from, to)) return made;
  }
  const Length width = 2.0 * rule_.turn_radius, tight = metres(tight_turn_m);
  auto way = bends(from, to, width, room_, rule_.turn_radius);
  if (!way) way = bends(from, to, width, room_, tight);
  if (!way) way = corners(from, to, room_);
  if (!way) {
    made.leaves_land = room_.is_inside({plane(from)}) && room_.is_inside({plane(to)});
    way = bends(from, to, width, open_room_, tight);
  }
  if (!way) way = corners(from, to, open_room_);
  if (!way) return std::nullopt;
  made.bends.insert(made.bends.end(), way->begin(), way->end());
  return made;
}

}  // namespace furrow::agents
