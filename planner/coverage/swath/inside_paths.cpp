#include "planner/coverage/swath/inside_paths.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace furrow::planner {

InsidePaths::InsidePaths(const LandPart& part) : grid_{part}, rings_{part.outer} {
  rings_.insert(rings_.end(), part.holes.begin(), part.holes.end());
  for (const RingM& ring : rings_) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PointM before = ring[(i + ring.size() - 1) % ring.size()];
      const PointM after = ring[(i + 1) % ring.size()];
      if (cross(ring[i] - before, after - ring[i]) < 0) {
        corners_.push_back({ring[i], before, after});
      }
    }
  }
  links_.resize(corners_.size());
}

// Whether a shortest way that comes from `from` could turn at `corner`: both its edges must lie on
// one side of the way.
bool InsidePaths::bends_around(PointM from, const Corner& corner) const {
  const PointM way = corner.at - from;
  const double slack = EdgeGrid::touch_m * norm(way);
  const double before = cross(way, corner.before - corner.at);
  const double after = cross(way, corner.after - corner.at);
  return !(before > slack && after < -slack) && !(before < -slack && after > slack);
}

const std::vector<InsidePaths::Link>& InsidePaths::links_of(std::size_t corner) const {
  std::optional<std::vector<Link>>& known = links_[corner];
  if (known) return *known;
  known.emplace();
  const Corner& here = corners_[corner];
  for (std::size_t other = 0; other < corners_.size(); ++other) {
    const Corner& there = corners_[other];
    if (other == corner || !bends_around(here.at, there) || !bends_around(there.at, here) ||
        !grid_.sees(here.at, there.at)) {
      continue;
    }
    known->push_back({other, norm(there.at - here.at)});
  }
  return *known;
}

// The shorter way round if both places lie on the same ring.
std::optional<PathM> InsidePaths::along_ring(PointM a, PointM b) const {
  const EdgeGrid::Edge* on_a = grid_.edge_at(a);
  const EdgeGrid::Edge* on_b = grid_.edge_at(b);
  if (!on_a || !on_b || on_a->ring != on_b->ring) return std::nullopt;
  const RingM& ring = rings_[static_cast<std::size_t>(on_a->ring)];
  if (on_a->place == on_b->place) return PathM{a, b};
  const auto walk = [&](PointM from, int place, PointM to, int last) {
    PathM path{from};
    const int size = static_cast<int>(ring.size());
    for (int i = place; i != last; i = (i + 1) % size) {
      path.push_back(ring[static_cast<std::size_t>((i + 1) % size)]);
    }
    path.push_back(to);
    return path;
  };
  PathM onwards = walk(a, on_a->place, b, on_b->place);
  PathM back = walk(b, on_b->place, a, on_a->place);
  std::reverse(back.begin(), back.end());
  return length_m(onwards) <= length_m(back) ? onwards : back;
}

InsidePaths::Fan InsidePaths::fan(PointM from) const {
  Fan made{from, std::vector<double>(corners_.size(), INFINITY)};
  using Open = std::pair<double, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  const auto reach = [&](std::size_t corner, double length_m) {
    if (length_m >= made.corner_m[corner]) return;
    made.corner_m[corner] = length_m;
    open.push({length_m, corner});
  };
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    if (bends_around(from, corners_[c]) && grid_.sees(from, corners_[c].at)) {
      reach(c, norm(corners_[c].at - from));
    }
  }
  while (!open.empty()) {
    const auto [length_m, corner] = open.top();
    open.pop();
    if (length_m > made.corner_m[corner]) continue;
    for (const Link& link : links_of(corner)) reach(link.to, length_m + link.length_m);
  }
  return made;
}

double InsidePaths::way_m(const Fan& fan, PointM to) const {
  if (is_convex() || grid_.sees(fan.from, to)) return norm(to - fan.from);
  double best_m = INFINITY;
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const double through_m = fan.corner_m[c] + norm(to - corners_[c].at);
    if (through_m < best_m && bends_around(to, corners_[c]) && grid_.sees(corners_[c].at, to)) {
      best_m = through_m;
    }
  }
  return best_m;
}

std::optional<PathM> InsidePaths::shortest(PointM a, PointM b) const {
  if (grid_.sees(a, b)) return PathM{a, b};
  std::optional<PathM> bound = along_ring(a, b);
  const double longest_m = bound ? length_m(*bound) * (1 + 1e-12) : INFINITY;
  std::optional<PathM> found = search(a, b, longest_m);
  return found ? found : bound;
}

std::optional<PathM> InsidePaths::search(PointM a, PointM b, double longest_m) const {
  const std::size_t none = corners_.size();
  std::vector<double> reached_m(corners_.size(), INFINITY);
  std::vector<std::size_t> came_from(corners_.size(), none);
  std::vector<bool> settled(corners_.size(), false);
  using Open = std::pair<double, std::size_t>;  // least length through here, corner (none: goal)
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  double goal_m = INFINITY;
  std::size_t goal_from = none;

  const auto reach = [&](std::size_t corner, double length_m, std::size_t from) {
    const double through_m = length_m + norm(b - corners_[corner].at);
    if (through_m > longest_m || length_m >= reached_m[corner]) return;
    reached_m[corner] = length_m;
    came_from[corner] = from;
    open.push({through_m, corner});
  };
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const double first_m = norm(corners_[c].at - a);
    if (first_m + norm(b - corners_[c].at) > longest_m || !bends_around(a, corners_[c])) continue;
    if (grid_.sees(a, corners_[c].at)) reach(c, first_m, none);
  }
  while (!open.empty()) {
    const auto [through_m, corner] = open.top();
    open.pop();
    if (through_m >= goal_m) break;
    if (settled[corner]) continue;
    settled[corner] = true;
    const double here_m = reached_m[corner];
    if (bends_around(b, corners_[corner]) && grid_.sees(corners_[corner].at, b)) {
      if (through_m < goal_m) {
        goal_m = through_m;
        goal_from = corner;
      }
      continue;  // nothing beyond is nearer to the goal than the straight way
    }
    for (const Link& link : links_of(corner)) {
      if (!settled[link.to]) reach(link.to, here_m + link.length_m, corner);
    }
  }
  if (goal_from == none) return std::nullopt;
  PathM path{b};
  for (std::size_t c = goal_from; c != none; c = came_from[c]) path.push_back(corners_[c].at);
  path.push_back(a);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace furrow::planner
