#include "planner/avoidance/room.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

constexpr double rounding_m = 1e-6;

bool is_within(const RingM& ring, PointM p) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    inside ^= is_left_of(p, ring[i], ring[j]);
  }
  return inside;
}

}  // namespace

double distance_m(PointM p, const PathM& path) {
  double least = path.empty() ? INFINITY : norm(p - path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    least = std::min(least, distance_m(p, path[i - 1], path[i]));
  }
  return least;
}

Room::Room(std::vector<CircleM> circles, std::vector<BarrierM> barriers, const LandParts& inside)
    : circles_{std::move(circles)}, barriers_{std::move(barriers)} {
  for (std::size_t i = 0; i < circles_.size(); ++i) {
    by_x_.push_back(i);
    widest_m_ = std::max(widest_m_, circles_[i].radius_m);
  }
  std::stable_sort(by_x_.begin(), by_x_.end(), [&](std::size_t a, std::size_t b) {
    return circles_[a].center.x < circles_[b].center.x;
  });
  for (const LandPart& part : inside) parts_.emplace_back(part);
}

Room Room::with(std::vector<CircleM> more) const {
  more.insert(more.begin(), circles_.begin(), circles_.end());
  return with_only(std::move(more));
}

Room Room::with_only(std::vector<CircleM> circles) const {
  Room room{std::move(circles), barriers_, {}};
  room.parts_ = parts_;
  return room;
}

std::vector<std::size_t> Room::circles_near(PointM a, PointM b, double more_m) const {
  const double reach_m = widest_m_ + more_m;
  std::vector<std::size_t> near;
  const double from_x = std::min(a.x, b.x) - reach_m, to_x = std::max(a.x, b.x) + reach_m;
  auto at = std::lower_bound(by_x_.begin(), by_x_.end(), from_x,
                             [&](std::size_t i, double x) { return circles_[i].center.x < x; });
  for (; at != by_x_.end() && circles_[*at].center.x <= to_x; ++at) {
    if (distance_m(circles_[*at].center, a, b) < circles_[*at].radius_m + more_m) {
      near.push_back(*at);
    }
  }
  std::sort(near.begin(), near.end());
  return near;
}

std::vector<std::size_t> Room::entered(const PathM& path) const {
  if (path.empty() || circles_.empty()) return {};
  const BoxM box = box_of(path);
  const PointM middle = 0.5 * (box.low + box.high);
  std::vector<std::size_t> met;
  for (const std::size_t i : circles_near(middle, middle, norm(box.high - box.low) / 2)) {
    if (distance_m(circles_[i].center, path) < circles_[i].radius_m - rounding_m) met.push_back(i);
  }
  return met;
}

bool Room::is_inside(const PathM& path) const {
  if (parts_.empty() || path.empty()) return true;
  return std::any_of(parts_.begin(), parts_.end(), [&](const EdgeGrid& part) {
    if (!part.contains(path.front())) return false;
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (!part.sees(path[i - 1], path[i])) return false;
    }
    return true;
  });
}

bool Room::is_clear_of(const BarrierM& barrier, const PathM& path) const {
  const BoxM a = box_of(path), b = box_of(barrier.ring);
  const double more_m = barrier.clearance_m;
  if (a.high.x + more_m < b.low.x || b.high.x + more_m < a.low.x || a.high.y + more_m < b.low.y ||
      b.high.y + more_m < a.low.y) {
    return true;
  }
  if (is_within(barrier.ring, path.front())) return false;
  for (std::size_t i = 0; i < barrier.ring.size(); ++i) {
    const PointM c = barrier.ring[i], d = barrier.ring[(i + 1) % barrier.ring.size()];
    for (std::size_t k = 1; k < path.size(); ++k) {
      const PointM from = path[k - 1], to = path[k];
      const bool is_near = apart_m(from, to, c, d) < more_m - rounding_m;
      if (is_near || cross_each_other(from, to, c, d)) return false;
    }
  }
  return true;
}

bool Room::is_clear_of_barriers(const PathM& path) const {
  return std::all_of(barriers_.begin(), barriers_.end(),
                     [&](const BarrierM& b) { return is_clear_of(b, path); });
}

}  // namespace furrow::planner
