#include "planner/avoidance/turns.hpp"

#include "planner/avoidance/crowd.hpp"

#include <cmath>
#include <numbers>

namespace furrow::planner {
namespace {

struct Trial {
  PathM path;
  double length_m;
  bool is_inside;
};

bool is_better(const Trial& a, const std::optional<Trial>& b) {
  if (!b) return true;
  if (a.is_inside != b->is_inside) return a.is_inside;
  return a.length_m < b->length_m;
}

std::optional<Trial> trial(const std::vector<CurveM>& curves, const Room& room) {
  Trial made{{}, 0, false};
  for (const CurveM& curve : curves) {
    const PathM path = tangent_path(curve, corner_rad);
    made.path.insert(made.path.end(), path.begin() + (made.path.empty() ? 0 : 1), path.end());
    made.length_m += length_m(curve);
  }
  if (!room.is_clear(made.path)) return std::nullopt;
  made.is_inside = room.is_inside(made.path);
  return made;
}

Pose shifted(Pose from, double ahead_m, double aside_m, double turn_rad) {
  const double c = std::cos(from.heading_rad), s = std::sin(from.heading_rad);
  return {
      from.at + FieldVector{metres(ahead_m * c - aside_m * s), metres(ahead_m * s + aside_m * c)},
      from.heading_rad + turn_rad};
}

Turn turn_of(const Trial& best) {
  Turn made{{}, metres(best.length_m), best.is_inside};
  for (const PointM p : best.path) made.way.push_back(at_m(p.x, p.y));
  return made;
}

}  // namespace

std::optional<Turn> strip_turn(Pose from, Pose to, Length radius, const Room& room) {
  std::optional<Trial> best = trial({dubins_curve(from, to, radius)}, room);
  if (best && best->is_inside) return turn_of(*best);
  const FieldVector way = to.at - from.at;
  const Pose middle{from.at + FieldVector{0.5 * way.x, 0.5 * way.y}, from.heading_rad};
  for (int ahead = -4; ahead <= 4; ++ahead) {
    for (int aside = -4; aside <= 4; ++aside) {
      for (int eighth = 0; eighth < 8; ++eighth) {
        const Pose via = shifted(middle, ahead * radius.base(), aside * radius.base(),
                                 eighth * std::numbers::pi / 4);
        const CurveM first = dubins_curve(from, via, radius),
                     second = dubins_curve(via, to, radius);
        if (best && best->is_inside && length_m(first) + length_m(second) >= best->length_m) {
          continue;
        }
        const auto tried = trial({first, second}, room);
        if (tried && is_better(*tried, best)) best = tried;
      }
    }
  }
  if (!best) return std::nullopt;
  return turn_of(*best);
}

}  // namespace furrow::planner
