#include "planner/coverage/swath/ragged_edges.hpp"

#include "planner/coverage/geos.hpp"
#include "planner/coverage/swath/strips.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace furrow::planner {
namespace {

constexpr int most_rounds = 10;
constexpr int first_apart = 2;    // round from which each missed place gets a strip of its own
constexpr double bend = 0.05;     // swaths by which an edge strip may pass a curved edge
constexpr double shortest = 0.1;  // swaths of edge that are worth a strip
constexpr double shortest_apart = 0.01;  // the same of a missed place
constexpr double widest_gap = 8.0;       // swaths between missed places that one strip still joins
constexpr double least_gain = 0.002;     // share of what a round sprays that was missed before

// A side of a ring, or a chord of it that passes over vertices.
struct Edge {
  PointM from, to;
  double bulge_m;  ///< How far passed-over vertices lie from it.
};

// Missed places along one edge, in its row frame.
struct Stretch {
  std::size_t edge;
  double low_m, high_m, missed_m2;
};

double distance_m(PointM p, const Edge& edge) { return planner::distance_m(p, edge.from, edge.to); }

PointM middle_of(const RingM& ring) {
  PointM sum{0, 0};
  for (const PointM p : ring) sum = sum + p;
  return (1.0 / static_cast<double>(ring.size())) * sum;
}

// Chords between `first` and `last` (taken round the ring) that pass vertices within `bend_m`.
// Source: Douglas, Peucker 1973.
void append_chords(const RingM& ring, std::size_t first, std::size_t last, double bend_m,
                   std::vector<Edge>& edges) {
  const Edge chord{ring[first % ring.size()], ring[last % ring.size()], 0};
  double furthest_m = 0;
  std::size_t split = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double away_m = distance_m(ring[i % ring.size()], chord);
    if (away_m > furthest_m) {
      furthest_m = away_m;
      split = i;
    }
  }
  if (furthest_m <= bend_m) {
    if (!(chord.from == chord.to)) edges.push_back({chord.from, chord.to, furthest_m});
    return;
  }
  append_chords(ring, first, split, bend_m, edges);
  append_chords(ring, split, last, bend_m, edges);
}

std::vector<Edge> edges_of(const LandParts& land, double bend_m) {
  std::vector<Edge> edges;
  const auto add = [&](const RingM& ring) {
    append_chords(ring, 0, ring.size() / 2, bend_m, edges);
    append_chords(ring, ring.size() / 2, ring.size(), bend_m, edges);
  };
  for (const LandPart& part : land) {
    add(part.outer);
    for (const RingM& hole : part.holes) add(hole);
  }
  return edges;
}

std::size_t nearest_edge(const std::vector<Edge>& edges, std::size_t count, PointM p) {
  std::size_t best = 0;
  double best_m = INFINITY;
  for (std::size_t e = 0; e < count; ++e) {
    const double away_m = distance_m(p, edges[e]);
    if (away_m < best_m) {
      best_m = away_m;
      best = e;
    }
  }
  return best;
}

// An edge half a swath beside a place inside `part`, along its longest side: a strip beside that
// edge runs through the place. Its middle would not do: of a crescent that lies outside.
Edge own_edge(const LandPart& part, double swath_m) {
  Edge longest{part.outer[0], part.outer[1], 0};
  each_edge(part, [&](PointM a, PointM b) {
    if (norm(b - a) > norm(longest.to - longest.from)) longest = {a, b, 0};
  });
  const PointM along = longest.to - longest.from;
  const PointM right = (swath_m / 2 / norm(along)) * PointM{along.y, -along.x};
  const PointM start = inner_place(part) + right;
  return {start, start + along, 0};
}

Stretch stretch_along(const std::vector<Edge>& edges, std::size_t edge, const PathM& places,
                      double missed_m2) {
  const RowFrame frame = RowFrame::along(edges[edge].to - edges[edge].from);
  Stretch stretch{edge, INFINITY, -INFINITY, missed_m2};
  for (const PointM p : places) {
    stretch.low_m = std::min(stretch.low_m, frame.to(p).x);
    stretch.high_m = std::max(stretch.high_m, frame.to(p).x);
  }
  return stretch;
}

// A place that lies around something has its middle at none of its edges, but its sides do: each
// takes its share of what is missed.
std::vector<Stretch> stretches_of_sides(const LandPart& part, const std::vector<Edge>& edges,
                                        std::size_t land_edges, double swath_m) {
  double around_m = 0;
  each_edge(part, [&](PointM a, PointM b) { around_m += norm(b - a); });
  std::vector<Stretch> made;
  each_edge(part, [&](PointM a, PointM b) {
    const PointM middle = a + 0.5 * (b - a);
    const std::size_t e = nearest_edge(edges, land_edges, middle);
    if (distance_m(middle, edges[e]) > swath_m) return;
    made.push_back(stretch_along(edges, e, {a, b}, area_m2(part) * norm(b - a) / around_m));
  });
  return made;
}

// Missed places by the edge that they lie at; far from any, or if `apart`, by an edge of their own,
// which is added.
std::vector<Stretch> stretches_of(const LandParts& missed, std::vector<Edge>& edges,
                                  std::size_t land_edges, double swath_m, bool apart) {
  const double gap_m = widest_gap * swath_m;
  std::map<std::size_t, std::vector<Stretch>> by_edge;
  for (const LandPart& part : missed) {
    const PointM middle = middle_of(part.outer);
    std::size_t e = nearest_edge(edges, land_edges, middle);
    const bool is_far = distance_m(middle, edges[e]) > swath_m;
    if (is_far && !apart) {
      const auto sides = stretches_of_sides(part, edges, land_edges, swath_m);
      for (const Stretch& side : sides) by_edge[side.edge].push_back(side);
      if (!sides.empty()) continue;
    }
    if (is_far || apart) {
      e = edges.size();
      edges.push_back(own_edge(part, swath_m));
    }
    by_edge[e].push_back(stretch_along(edges, e, part.outer, area_m2(part)));
  }
  std::vector<Stretch> joined;
  for (auto& [edge, list] : by_edge) {
    std::sort(list.begin(), list.end(),
              [](const Stretch& a, const Stretch& b) { return a.low_m < b.low_m; });
    bool first = true;
    for (const Stretch& next : list) {
      if (!first && next.low_m <= joined.back().high_m + gap_m) {
        joined.back().high_m = std::max(joined.back().high_m, next.high_m);
        joined.back().missed_m2 += next.missed_m2;
      } else {
        joined.push_back(next);
      }
      first = false;
    }
  }
  return joined;
}

struct Interval {
  double low_m, high_m;
};

// The strips beside the edge that cover the stretch, as far as flight is allowed there: half a
// swath inside, or nearer to the edge where the land is too narrow for that.
std::vector<GroundStrip> strips_beside(const LandPart& flight, const Edge& edge,
                                       const Stretch& stretch, double swath_m, double least_m) {
  const RowFrame frame = RowFrame::along(edge.to - edge.from);
  const double edge_v = frame.to(edge.from).y;
  std::vector<GroundStrip> strips;
  std::vector<Interval> open{{stretch.low_m, stretch.high_m}};
  for (const double inside : {0.5, 0.25, 0.1, 0.01}) {
    const Row row{edge_v + inside * swath_m - edge.bulge_m, swath_m / 2};
    std::vector<Interval> left;
    const auto chords = chords_at(flight, {}, frame, row, EdgeMode::cover_all);
    for (Interval gap : open) {
      for (const Chord& chord : chords) {
        const double low = std::max(chord.low_m, gap.low_m);
        const double high = std::min(chord.high_m, gap.high_m);
        if (high - low < least_m) continue;
        strips.push_back({frame.from({low, row.v_m}), frame.from({high, row.v_m}), swath_m / 2});
        if (low > gap.low_m) left.push_back({gap.low_m, low});
        gap.low_m = high;
      }
      if (gap.low_m < gap.high_m) left.push_back(gap);
    }
    open = std::move(left);
  }
  return strips;
}

// A strip beside an edge; edges are numbered along their ring.
struct EdgeStrip {
  std::size_t edge;
  GroundStrip strip;
};

// Strips at the stretches that miss the most, until `enough_m2` of missed land is dealt with.
std::vector<EdgeStrip> strips_at(const LandPart& flight, const std::vector<Edge>& edges,
                                 std::vector<Stretch> stretches, double swath_m, double worth_m,
                                 double enough_m2) {
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](const Stretch& a, const Stretch& b) { return a.missed_m2 > b.missed_m2; });
  std::vector<EdgeStrip> made;
  for (const Stretch& stretch : stretches) {
    if (enough_m2 <= 0) break;
    for (const GroundStrip& strip :
         strips_beside(flight, edges[stretch.edge], stretch, swath_m, worth_m)) {
      made.push_back({stretch.edge, strip});
    }
    enough_m2 -= stretch.missed_m2;
  }
  return made;
}

LandParts missed_by(const std::vector<EdgeStrip>& strips, const LandParts& land) {
  std::vector<SprayedRun> runs;
  runs.reserve(strips.size());
  for (const EdgeStrip& s : strips) {
    runs.push_back({{s.strip.a, s.strip.b}, 2 * s.strip.half_width_m});
  }
  return missed_land(runs, land);
}

double swept_m2(const std::vector<EdgeStrip>& strips) {
  double sum = 0;
  for (const EdgeStrip& s : strips) sum += norm(s.strip.b - s.strip.a) * 2 * s.strip.half_width_m;
  return sum;
}

// Strips that follow each other along the edge, end to end, become one chain.
std::vector<StripGroup> chains_of(std::vector<EdgeStrip> strips, double swath_m) {
  std::stable_sort(strips.begin(), strips.end(),
                   [](const EdgeStrip& a, const EdgeStrip& b) { return a.edge < b.edge; });
  std::vector<StripGroup> groups;
  for (const EdgeStrip& next : strips) {
    if (groups.empty() || norm(groups.back().strips.back().b - next.strip.a) > swath_m) {
      groups.push_back({{}, Flown::in_a_chain});
    }
    groups.back().strips.push_back(next.strip);
  }
  return groups;
}

}  // namespace

EdgeStrips edge_strips(const LandPart& flight, const LandParts& land,
                       const std::vector<SprayedRun>& sprayed, double swath_m, double tolerance,
                       double least_m) {
  std::vector<Edge> edges = edges_of(land, bend * swath_m);
  const std::size_t land_edges = edges.size();
  const double allowed_m2 = tolerance * area_m2(land);
  std::vector<EdgeStrip> added;
  LandParts missed = missed_land(sprayed, land);
  for (int round = 0; round < most_rounds && area_m2(missed) > allowed_m2; ++round) {
    const bool apart = round >= first_apart;
    const double worth_m = std::max(least_m, (apart ? shortest_apart : shortest) * swath_m);
    std::vector<Stretch> stretches = stretches_of(missed, edges, land_edges, swath_m, apart);
    const auto more = strips_at(flight, edges, std::move(stretches), swath_m, worth_m,
                                area_m2(missed) - allowed_m2);
    LandParts left = more.empty() ? missed : missed_by(more, missed);
    if (area_m2(missed) - area_m2(left) <= least_gain * swept_m2(more)) {
      if (apart) break;
      continue;
    }
    added.insert(added.end(), more.begin(), more.end());
    missed = std::move(left);
  }
  return {chains_of(std::move(added), swath_m), area_m2(missed)};
}

}  // namespace furrow::planner
