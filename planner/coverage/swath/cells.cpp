#include "planner/coverage/swath/cells.hpp"

#include "planner/coverage/geos.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace furrow::planner {
namespace {

constexpr double overshoot_m = 1e-6;  // a cut must cross the edge it ends at, rounding or not

struct Event {
  PointM at;
};

std::vector<Event> events_of(const LandPart& part, RowFrame frame) {
  std::vector<Event> events;
  const auto visit = [&](const RingM& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PointM before = frame.to(ring[(i + ring.size() - 1) % ring.size()]);
      const PointM here = frame.to(ring[i]);
      const PointM after = frame.to(ring[(i + 1) % ring.size()]);
      const bool reflex = cross(here - before, after - here) < 0;
      const double down = before.y - here.y, up = after.y - here.y;
      const double level = 1e-9 * (norm(before - here) + norm(after - here));
      const bool monotone = (down > level && up < -level) || (down < -level && up > level);
      if (reflex && !monotone) events.push_back({ring[i]});
    }
  };
  visit(part.outer);
  for (const RingM& hole : part.holes) visit(hole);
  return events;
}

// From `at` along `way`, the distance to the nearest edge ahead.
double reach_m(const LandPart& part, PointM at, PointM way) {
  double best = INFINITY;
  each_edge(part, [&](PointM a, PointM b) {
    const double side_a = cross(way, a - at), side_b = cross(way, b - at);
    if ((side_a > 0 && side_b > 0) || (side_a < 0 && side_b < 0)) return;
    const double t_a = dot(way, a - at), t_b = dot(way, b - at);
    const double t =
        side_a == side_b ? std::min(t_a, t_b) : t_a + (t_b - t_a) * side_a / (side_a - side_b);
    if (t > 10 * overshoot_m) best = std::min(best, t);
  });
  return best;
}

// Whether a face between cuts and edges is land. The place inside a face without width may be a
// vertex; then areas tell.
bool is_land(const LandPart& face, const LandPart& part, const EdgeGrid& edges) {
  const PointM place = inner_place(face);
  if (!edges.edge_at(place)) return edges.contains(place);
  return area_m2(subtracted({face}, {part})) < area_m2(face) / 2;
}

}  // namespace

LandParts row_cells(const LandPart& part, const EdgeGrid& edges, RowFrame frame) {
  std::vector<PathM> lines;
  for (const Event& event : events_of(part, frame)) {
    for (const double sign : {-1.0, 1.0}) {
      const PointM way = sign * frame.from({1, 0});
      const double length = reach_m(part, event.at, way);
      if (length == INFINITY || !edges.contains(event.at + (length / 2) * way)) continue;
      lines.push_back({event.at, event.at + (length + overshoot_m) * way});
    }
  }
  if (lines.empty()) return {part};
  const auto add_ring = [&](const RingM& ring) {
    PathM closed = ring;
    closed.push_back(ring.front());
    lines.push_back(std::move(closed));
  };
  add_ring(part.outer);
  for (const RingM& hole : part.holes) add_ring(hole);
  LandParts cells;
  for (LandPart& face : faces(lines)) {
    if (is_land(face, part, edges)) cells.push_back(std::move(face));
  }
  return cells;
}

std::vector<RowFrame> edge_directions(const LandPart& part, std::size_t most) {
  constexpr double bins = 3142;  // of a half turn: a millirad each
  std::map<int, std::pair<double, PointM>> by_angle;
  each_edge(part, [&](PointM a, PointM b) {
    const PointM along = b - a;
    if (norm(along) == 0) return;
    double share = std::atan2(along.y, along.x) / M_PI;
    if (share < 0) share += 1;
    auto& [sum, longest] = by_angle[static_cast<int>(std::lround(share * bins)) % 3142];
    sum += norm(along);
    if (norm(along) > norm(longest)) longest = along;
  });
  std::vector<std::pair<double, PointM>> ranked;
  ranked.reserve(by_angle.size());
  for (const auto& [bin, entry] : by_angle) ranked.push_back(entry);
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<RowFrame> frames;
  for (std::size_t i = 0; i < std::min(most, ranked.size()); ++i) {
    frames.push_back(RowFrame::along(ranked[i].second));
  }
  return frames;
}

}  // namespace furrow::planner
