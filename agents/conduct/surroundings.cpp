#include "agents/conduct/surroundings.hpp"

#include "agents/xy.hpp"
#include "planner/avoidance/onboard.hpp"

#include <algorithm>
#include <utility>

namespace furrow::agents {
namespace {

using Bends = std::vector<FieldPoint>;

constexpr double tight_turn_m = 0.01;  // on the spot
constexpr double way_out_m = 0.05;     // beyond the clearance
constexpr int most_crowds = 100;       // on one leg

// From one crowd of obstacles to the next.
std::optional<Bends> bends(FieldPoint from, FieldPoint to, Length swath, const planner::Room& room,
                           Length turn_radius) {
  const Xy ahead = xy_m(to) - xy_m(from);
  planner::OnboardLine line{{from, std::atan2(ahead.y, ahead.x)}, from, to, swath};
  Bends all;
  for (int i = 0; i < most_crowds; ++i) {
    const auto detour = planner::onboard_detour(line, room, turn_radius);
    if (!detour && detour.error() == planner::NoDetour::nothing_ahead) return all;
    if (!detour) return std::nullopt;
    all.insert(all.end(), detour->way.begin() + 1, detour->way.end());
    line.pose.at = all.back();
  }
  return std::nullopt;
}

}  // namespace

Surroundings::Surroundings(AvoidanceRule rule)
    : rule_{std::move(rule)}, room_{rule_.planned}, open_room_{rule_.planned.without_edges()} {}

double Surroundings::kept_m(const SeenObstacle& o) const {
  return (o.radius + rule_.clearance).base();
}

bool Surroundings::learn(const SeenObstacle& obstacle) {
  if (std::find(seen_.begin(), seen_.end(), obstacle) != seen_.end()) return false;
  seen_.push_back(obstacle);
  const Xy at = xy_m(obstacle.center);
  room_ = room_.with({{{at.x, at.y}, kept_m(obstacle)}});
  open_room_ = room_.without_edges();
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

std::optional<Bends> Surroundings::ferry_bends(FieldPoint from, FieldPoint to) const {
  if (!clear_m(from, to)) return Bends{};
  if (is_too_near(to)) return std::nullopt;
  Bends out;
  const auto near = std::find_if(seen_.begin(), seen_.end(), [&](const SeenObstacle& o) {
    return distance(from, o.center).base() < kept_m(o);
  });
  if (near != seen_.end()) {
    const Xy away = xy_m(from) - xy_m(near->center);
    const double far_m = norm(away);
    const Xy outward = far_m > 0.0 ? (1.0 / far_m) * away : Xy{0.0, 1.0};
    from = field_point(xy_m(near->center) + (kept_m(*near) + way_out_m) * outward);
    out.push_back(from);
    if (!clear_m(from, to)) return out;
  }
  const Length width = 2.0 * rule_.turn_radius, tight = metres(tight_turn_m);
  auto way = bends(from, to, width, room_, rule_.turn_radius);
  if (!way) way = bends(from, to, width, room_, tight);
  if (!way) way = bends(from, to, width, open_room_, tight);
  if (!way) return std::nullopt;
  out.insert(out.end(), way->begin(), way->end());
  return out;
}

}  // namespace furrow::agents
