#include "planner/avoidance/clear_way.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow::planner {
namespace {

constexpr int corners = 8;
constexpr double spare_m = 0.05;     // of corners, beyond their circle
constexpr double reach_m = 60;       // of circles, beside the straight way
constexpr double rounding_m = 1e-3;  // of an end on its circle

// Circles that hold `from` or `to` end there.
Room with_free_ends(const Room& room, PointM from, PointM to) {
  std::vector<CircleM> circles = room.circles();
  for (CircleM& c : circles) {
    const double nearest_m = std::min(norm(from - c.center), norm(to - c.center));
    c.radius_m = std::min(c.radius_m, std::max(0.0, nearest_m - rounding_m));
  }
  return room.with_only(std::move(circles));
}

std::vector<PointM> corners_around(const CircleM& circle) {
  const double out_m = circle.radius_m / std::cos(std::numbers::pi / corners) + spare_m;
  std::vector<PointM> around;
  around.reserve(corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    around.push_back(circle.center + out_m * PointM{std::cos(angle), std::sin(angle)});
  }
  return around;
}

// The start, the goal, and what may lie between.
std::vector<PointM> places(PointM from, PointM to, const Room& room) {
  std::vector<PointM> all{from, to};
  for (const std::size_t i : room.circles_near(from, to, reach_m)) {
    for (const PointM p : corners_around(room.circles()[i])) {
      if (room.is_free({p})) all.push_back(p);
    }
  }
  return all;
}

PathM traced(const std::vector<PointM>& at, const std::vector<std::size_t>& before) {
  PathM way;
  for (std::size_t i = 1; i != 0; i = before[i]) way.push_back(at[i]);
  way.push_back(at[0]);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace

std::optional<PathM> clear_way(PointM from, PointM to, const Room& given) {
  const Room room = with_free_ends(given, from, to);
  if (room.is_free({from, to})) return PathM{from, to};
  const std::vector<PointM> at = places(from, to, room);
  std::vector<double> gone_m(at.size(), INFINITY);
  std::vector<std::size_t> before(at.size(), 0);
  std::vector<bool> is_done(at.size(), false);
  gone_m[0] = 0;
  const auto left_m = [&](std::size_t i) { return gone_m[i] + norm(to - at[i]); };
  for (;;) {
    std::size_t next = at.size();
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (is_done[i] || gone_m[i] == INFINITY) continue;
      if (next == at.size() || left_m(i) < left_m(next)) next = i;
    }
    if (next == at.size()) return std::nullopt;
    if (next == 1) return traced(at, before);
    is_done[next] = true;
    for (std::size_t i = 1; i < at.size(); ++i) {
      const double by_m = gone_m[next] + norm(at[i] - at[next]);
      if (is_done[i] || by_m >= gone_m[i] || !room.is_free({at[next], at[i]})) continue;
      gone_m[i] = by_m;
      before[i] = next;
    }
  }
}

}  // namespace furrow::planner
