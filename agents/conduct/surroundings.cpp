#include "agents/conduct/surroundings.hpp"

#include "planner/avoidance/clear_way.hpp"

#include <algorithm>
#include <utility>

namespace furrow::agents {
namespace {

using Bends = std::vector<FieldPoint>;

constexpr double tight_turn_m = 0.01;  // on the spot
constexpr double same_place_m = 1e-6;
constexpr double way_out_m = 0.05;  // beyond the clearance

// Of a ferry, as short as can be.
std::optional<Bends> bends(FieldPoint from, FieldPoint to, Length swath, const planner::Room& room,
                           Length turn_radius) {
  const auto found =
      planner::onboard_way(from, to, swath, room, turn_radius, {.length = 1.0, .area = 0.0});
  if (!found) return std::nullopt;
  Bends all;
  for (const StripBend& bend : found->bends) all.push_back(bend.at);
  return all;
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

// Where along a line of unit vector `ahead` from `from` the clearance of `o` that holds the place
// at `along_m` ends [m].
double Surroundings::leaves_m(const SeenObstacle& o, Xy from, Xy ahead) const {
  const Xy there = xy_m(o.center) - from;
  const double along = dot(there, ahead), beside_square = dot(there, there) - along * along;
  return along + std::sqrt(std::max(0.0, kept_m(o) * kept_m(o) - beside_square)) + way_out_m;
}

// The first clear place from `at_m` on.
std::optional<double> Surroundings::first_clear_m(Xy from, Xy ahead, double length_m,
                                                  double at_m) const {
  for (std::size_t i = 0; i <= seen_.size() && at_m <= length_m; ++i) {
    const FieldPoint place = field_point(from + at_m * ahead);
    const auto near = std::find_if(seen_.begin(), seen_.end(), [&](const SeenObstacle& o) {
      return distance(place, o.center).base() < kept_m(o);
    });
    if (near == seen_.end()) return at_m;
    at_m = leaves_m(*near, from, ahead);
  }
  return std::nullopt;
}

// Where a strip may begin: at the first clear place, or behind an obstacle that leaves no room for
// turns before it.
std::vector<double> Surroundings::beginnings_m(Xy from, Xy ahead, double length_m) const {
  const auto first_m = first_clear_m(from, ahead, length_m, 0.0);
  if (!first_m) return {};
  std::vector<double> all{*first_m};
  const FieldPoint begin = field_point(from + *first_m * ahead);
  const auto clear = clear_m(begin, field_point(from + length_m * ahead));
  if (!clear || *clear > 2.0 * (rule_.turn_radius + rule_.clearance).base()) return all;
  const auto behind_m = first_clear_m(from, ahead, length_m, *first_m + *clear + way_out_m);
  if (behind_m) all.push_back(*behind_m);
  return all;
}

std::optional<Surroundings::ClearPart> Surroundings::clear_part(FieldPoint from, FieldPoint to,
                                                                Length swath) const {
  if (!clear_m(from, to)) return ClearPart{from, to};
  const Xy way = xy_m(to) - xy_m(from);
  const double length_m = norm(way);
  if (length_m < same_place_m) return std::nullopt;
  const Xy ahead = (1.0 / length_m) * way;
  std::optional<ClearPart> widest;
  for (const double ends_m : beginnings_m(xy_m(to), -1.0 * ahead, length_m)) {
    for (const double begins_m : beginnings_m(xy_m(from), ahead, length_m)) {
      if (begins_m + ends_m >= length_m) continue;
      const ClearPart part{begins_m > 0.0 ? field_point(xy_m(from) + begins_m * ahead) : from,
                           ends_m > 0.0 ? field_point(xy_m(to) - ends_m * ahead) : to};
      if (!widest) widest = part;
      if (strip_bends(part.from, part.to, swath)) return part;
    }
  }
  return widest;
}

std::optional<std::vector<StripBend>> Surroundings::strip_bends(FieldPoint from, FieldPoint to,
                                                                Length swath) const {
  if (!clear_m(from, to)) return std::vector<StripBend>{};
  auto way = planner::onboard_way(from, to, swath, room_, rule_.turn_radius, rule_.weights);
  if (!way) return std::nullopt;
  return std::move(way->bends);
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
