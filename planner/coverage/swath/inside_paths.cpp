#include "planner/coverage/swath/inside_paths.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

namespace furrow::planner {
namespace {

using Open = std::pair<double, std::size_t>;  // a length, and the corner that it leads to
using Nearest = std::priority_queue<Open, std::vector<Open>, std::greater<>>;

}  // namespace

InsidePaths::InsidePaths(const LandPart& part) : grid_{part}, rings_{part.outer} {
  rings_.insert(rings_.end(), part.holes.begin(), part.holes.end());
  for (const RingM& ring : rings_) add_corners(ring);
  links_.resize(corners_.size());
  all_rings_.resize(ring_corners_.size());
  std::iota(all_rings_.begin(), all_rings_.end(), std::size_t{0});
}

void InsidePaths::add_corners(const RingM& ring) {
  const std::size_t first = corners_.size();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PointM before = ring[(i + ring.size() - 1) % ring.size()];
    const PointM after = ring[(i + 1) % ring.size()];
    if (cross(ring[i] - before, after - ring[i]) < 0) {
      corners_.push_back({ring[i], before, after});
    }
  }
  if (first == corners_.size()) return;
  PointM low = corners_[first].at, high = low;
  for (std::size_t c = first; c < corners_.size(); ++c) {
    const PointM p = corners_[c].at;
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  ring_corners_.push_back(
      {first, corners_.size(), 0.5 * (low + high), 0.5 * norm(high - low) + EdgeGrid::touch_m});
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

// False where no corner of the ring lies in a direction in which a way could turn at `here`: there
// both its edges lie on one side of the way.
bool InsidePaths::may_bend_to(const Corner& here, const RingCorners& ring) const {
  const PointM before = here.before - here.at, after = here.after - here.at;
  const PointM way = ring.middle - here.at;
  const double rounding = EdgeGrid::touch_m * (norm(way) + ring.radius_m);
  const double to_before = cross(way, before), to_after = cross(way, after);
  const double slack_before = ring.radius_m * norm(before) + rounding;
  const double slack_after = ring.radius_m * norm(after) + rounding;
  return !(to_before > slack_before && to_after < -slack_after) &&
         !(to_before < -slack_before && to_after > slack_after);
}

// Calls `use(link)` for the corners that a way may bend at next, seen or not.
template <class Use>
void InsidePaths::each_bend_from(std::size_t corner, Use use) const {
  const Corner& here = corners_[corner];
  for (const RingCorners& ring : ring_corners_) {
    if (!may_bend_to(here, ring)) continue;
    for (std::size_t other = ring.first; other < ring.stop; ++other) {
      const Corner& there = corners_[other];
      if (other == corner || !bends_around(there.at, here) || !bends_around(here.at, there)) {
        continue;
      }
      use(Link{other, norm(there.at - here.at)});
    }
  }
}

const std::vector<InsidePaths::Link>& InsidePaths::links_of(std::size_t corner) const {
  std::optional<std::vector<Link>>& known = links_[corner];
  if (known) return *known;
  known.emplace();
  each_bend_from(corner, [&](const Link& link) {
    if (grid_.sees(corners_[corner].at, corners_[link.to].at)) known->push_back(link);
  });
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
  Fan made{from,
           std::vector<double>(corners_.size(), INFINITY),
           std::vector<std::size_t>(corners_.size(), straight),
           {}};
  Nearest open;
  const auto reach = [&](std::size_t corner, double length_m, std::size_t before) {
    if (length_m >= made.corner_m[corner]) return;
    made.corner_m[corner] = length_m;
    made.before[corner] = before;
    open.push({length_m, corner});
  };
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    if (bends_around(from, corners_[c]) && grid_.sees(from, corners_[c].at)) {
      reach(c, norm(corners_[c].at - from), straight);
    }
  }
  while (!open.empty()) {
    const double length_m = open.top().first;
    const std::size_t corner = open.top().second;
    open.pop();
    if (length_m > made.corner_m[corner]) continue;
    // Looked along only where that would be shorter: few links are.
    each_bend_from(corner, [&](const Link& link) {
      if (length_m + link.length_m >= made.corner_m[link.to]) return;
      if (!grid_.sees(corners_[corner].at, corners_[link.to].at)) return;
      reach(link.to, length_m + link.length_m, corner);
    });
  }
  for (const RingCorners& ring : ring_corners_) {
    const auto first = made.corner_m.begin() + static_cast<std::ptrdiff_t>(ring.first);
    const auto stop = made.corner_m.begin() + static_cast<std::ptrdiff_t>(ring.stop);
    made.ring_m.push_back(*std::min_element(first, stop));
  }
  return made;
}

// The shortest way past a corner, if it is shorter than `longest_m`.
std::optional<InsidePaths::Arrival> InsidePaths::past_within(
    const Fan& fan, PointM to, double longest_m, std::span<const std::size_t> rings) const {
  std::vector<Open> open;
  for (const std::size_t r : rings) {
    const RingCorners& ring = ring_corners_[r];
    const double least_m = fan.ring_m[r] - ring.radius_m;  // and the way to its middle
    if (norm(to - ring.middle) >= longest_m - least_m) continue;
    for (std::size_t c = ring.first; c < ring.stop; ++c) {
      const double way_m = fan.corner_m[c] + norm(to - corners_[c].at);
      if (way_m < longest_m && bends_around(to, corners_[c])) open.emplace_back(way_m, c);
    }
  }
  for (Nearest nearest{{}, std::move(open)}; !nearest.empty(); nearest.pop()) {
    const auto [way_m, past] = nearest.top();
    if (grid_.sees(corners_[past].at, to)) return Arrival{way_m, past};
  }
  return std::nullopt;
}

// The shortest of `known` and the ways past a corner. Most ways are hardly longer than straight.
InsidePaths::Arrival InsidePaths::nearest_past(const Fan& fan, PointM to, Arrival known,
                                               std::span<const std::size_t> rings) const {
  for (const double hardly : {1.01, 1.1}) {
    const double near_m = hardly * norm(to - fan.from);
    if (near_m >= known.way_m) break;
    if (const auto found = past_within(fan, to, near_m, rings)) return *found;
  }
  return past_within(fan, to, known.way_m, rings).value_or(known);
}

InsidePaths::Arrival InsidePaths::arrival(const Fan& fan, PointM to) const {
  if (is_convex() || grid_.sees(fan.from, to)) return {norm(to - fan.from), straight};
  return nearest_past(fan, to, {INFINITY, straight}, all_rings_);
}

double InsidePaths::way_m(const Fan& fan, PointM to) const { return arrival(fan, to).way_m; }

std::optional<PathM> InsidePaths::way(const Fan& fan, PointM to) const {
  const Arrival last = arrival(fan, to);
  if (last.way_m == INFINITY) return std::nullopt;
  return traced(fan.from, fan.before, last.past, to);
}

PathM InsidePaths::traced(PointM from, const std::vector<std::size_t>& before, std::size_t last,
                          PointM to) const {
  PathM path{to};
  for (std::size_t c = last; c != straight; c = before[c]) path.push_back(corners_[c].at);
  path.push_back(from);
  std::reverse(path.begin(), path.end());
  return path;
}

// Whether the triangle is land, where `apex` sees `a` and `b`.
bool InsidePaths::is_clear(PointM apex, PointM a, PointM b) const {
  if (!grid_.sees(a, b)) return false;
  const double turn = cross(a - apex, b - apex) < 0 ? -1 : 1;
  const auto is_inside = [&](PointM p) {
    return turn * cross(a - apex, p - apex) >= 0 && turn * cross(b - a, p - a) >= 0 &&
           turn * cross(apex - b, p - b) >= 0;
  };
  return std::none_of(rings_.begin() + 1, rings_.end(), [&](const RingM& hole) {
    return std::any_of(hole.begin(), hole.end(), is_inside);
  });
}

// Those past whose corners a way to a place of the line may be shorter than past `apex`.
std::vector<std::size_t> InsidePaths::rings_near(const Fan& fan, std::span<const PointM> line,
                                                 double to_apex_m, PointM apex) const {
  const double longest_m =
      to_apex_m + std::max(norm(line.front() - apex), norm(line.back() - apex));
  std::vector<std::size_t> near;
  for (std::size_t r = 0; r < ring_corners_.size(); ++r) {
    const RingCorners& ring = ring_corners_[r];
    const double least_m = fan.ring_m[r] - ring.radius_m + EdgeGrid::touch_m;
    const double way_m = distance_m(ring.middle, line.front(), line.back()) - EdgeGrid::touch_m;
    if (way_m < longest_m - least_m) near.push_back(r);
  }
  return near;
}

// Everything between the ends of a line.
void InsidePaths::fill(const Fan& fan, std::span<const PointM> line, Arrival first, Arrival last,
                       std::span<double> ways_m) const {
  if (line.size() <= 2) return;
  const bool is_alike = first.past == last.past && std::max(first.way_m, last.way_m) < INFINITY;
  const bool is_straight = first.past == straight;
  const PointM apex = is_straight ? fan.from : corners_[first.past].at;
  if (is_alike && is_clear(apex, line.front(), line.back())) {
    const double to_apex_m = is_straight ? 0.0 : fan.corner_m[first.past];
    // Around holes another way may be shorter in the middle of a line though at no end of it.
    const bool may_be_shorter = !is_straight && rings_.size() > 1;
    const auto rings =
        may_be_shorter ? rings_near(fan, line, to_apex_m, apex) : std::vector<std::size_t>{};
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const Arrival past{to_apex_m + norm(line[i] - apex), first.past};
      ways_m[i] = may_be_shorter ? nearest_past(fan, line[i], past, rings).way_m : past.way_m;
    }
    return;
  }
  const std::size_t middle = line.size() / 2;
  const Arrival half = arrival(fan, line[middle]);
  ways_m[middle] = half.way_m;
  fill(fan, line.first(middle + 1), first, half, ways_m.first(middle + 1));
  fill(fan, line.subspan(middle), half, last, ways_m.subspan(middle));
}

std::vector<double> InsidePaths::ways_m(const Fan& fan, std::span<const PointM> line) const {
  std::vector<double> ways_m(line.size());
  if (line.empty()) return ways_m;
  const Arrival first = arrival(fan, line.front()), last = arrival(fan, line.back());
  ways_m.front() = first.way_m;
  ways_m.back() = last.way_m;
  fill(fan, line, first, last, ways_m);
  return ways_m;
}

std::optional<PathM> InsidePaths::shortest(PointM a, PointM b) const {
  if (grid_.sees(a, b)) return PathM{a, b};
  std::optional<PathM> bound = along_ring(a, b);
  const double longest_m = bound ? length_m(*bound) * (1 + 1e-12) : INFINITY;
  std::optional<PathM> found = search(a, b, longest_m);
  return found ? found : bound;
}

std::optional<PathM> InsidePaths::search(PointM a, PointM b, double longest_m) const {
  std::vector<double> reached_m(corners_.size(), INFINITY);
  std::vector<std::size_t> came_from(corners_.size(), straight);
  std::vector<bool> settled(corners_.size(), false);
  Nearest open;  // least length through here
  double goal_m = INFINITY;
  std::size_t goal_from = straight;

  const auto reach = [&](std::size_t corner, double length_m, std::size_t from) {
    const double through_m = length_m + norm(b - corners_[corner].at);
    if (through_m > longest_m || length_m >= reached_m[corner]) return;
    reached_m[corner] = length_m;
    came_from[corner] = from;
    open.push({through_m, corner});
  };
  std::vector<Open> first_seen;
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const double first_m = norm(corners_[c].at - a);
    if (first_m + norm(b - corners_[c].at) > longest_m || !bends_around(a, corners_[c])) continue;
    first_seen.emplace_back(first_m + norm(b - corners_[c].at), c);
  }
  Nearest unseen{{}, std::move(first_seen)};  // the same of straight ways, not yet looked at
  const auto look = [&] {
    const std::size_t c = unseen.top().second;
    unseen.pop();
    if (grid_.sees(a, corners_[c].at)) reach(c, norm(corners_[c].at - a), straight);
  };
  while (!open.empty() || !unseen.empty()) {
    if (open.empty() || (!unseen.empty() && unseen.top() <= open.top())) {
      if (unseen.top().first >= goal_m) break;
      look();
      continue;
    }
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
  if (goal_from == straight) return std::nullopt;
  return traced(a, came_from, goal_from, b);
}

}  // namespace furrow::planner
