#include "planner/coverage/swath/ragged_edges.hpp"

#include "planner/coverage/swath/strips.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace furrow::planner {
namespace {

constexpr int most_rounds = 3;
constexpr double bend = 0.05;       // swaths by which an edge strip may pass a curved edge
constexpr double widest_gap = 8.0;  // swaths between missed places that one strip still joins

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

double distance_m(PointM p, const Edge& edge) {
  const PointM along = edge.to - edge.from;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - edge.from, along) / square, 0.0, 1.0) : 0.0;
  return norm(p - (edge.from + t * along));
}

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

std::size_t nearest_edge(const std::vector<Edge>& edges, PointM p) {
  std::size_t best = 0;
  double best_m = INFINITY;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const double away_m = distance_m(p, edges[e]);
    if (away_m < best_m) {
      best_m = away_m;
      best = e;
    }
  }
  return best;
}

std::vector<Stretch> stretches_of(const LandParts& missed, const std::vector<Edge>& edges,
                                  double gap_m) {
  std::map<std::size_t, std::vector<Stretch>> by_edge;
  for (const LandPart& part : missed) {
    const std::size_t e = nearest_edge(edges, middle_of(part.outer));
    const RowFrame frame = RowFrame::along(edges[e].to - edges[e].from);
    Stretch stretch{e, INFINITY, -INFINITY, area_m2(part)};
    for (const PointM p : part.outer) {
      stretch.low_m = std::min(stretch.low_m, frame.to(p).x);
      stretch.high_m = std::max(stretch.high_m, frame.to(p).x);
    }
    by_edge[e].push_back(stretch);
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

// The strip beside the edge that covers the stretch, as far as flight is allowed there.
std::vector<GroundStrip> strips_beside(const LandPart& flight, const Edge& edge,
                                       const Stretch& stretch, double swath_m, double least_m) {
  const RowFrame frame = RowFrame::along(edge.to - edge.from);
  const double edge_v = frame.to(edge.from).y;
  std::vector<GroundStrip> strips;
  const Row row{edge_v + swath_m / 2 - edge.bulge_m, swath_m / 2};
  for (const Chord& chord : chords_at(flight, {}, frame, row, EdgeMode::cover_all)) {
    const double low = std::max(chord.low_m, stretch.low_m);
    const double high = std::min(chord.high_m, stretch.high_m);
    if (high - low < std::max(least_m, 1e-6)) continue;
    strips.push_back({frame.from({low, row.v_m}), frame.from({high, row.v_m}), swath_m / 2});
  }
  return strips;
}

LandParts missed_by(const std::vector<GroundStrip>& strips, const LandParts& land) {
  std::vector<SprayedRun> runs;
  for (const GroundStrip& s : strips) runs.push_back({{s.a, s.b}, 2 * s.half_width_m});
  return missed_land(runs, land);
}

// A strip beside an edge; edges are numbered along their ring.
struct EdgeStrip {
  std::size_t edge;
  GroundStrip strip;
};

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

std::vector<StripGroup> edge_strips(const LandPart& flight, const LandParts& land,
                                    const std::vector<SprayedRun>& sprayed, double swath_m,
                                    double tolerance, double least_m) {
  const std::vector<Edge> edges = edges_of(land, bend * swath_m);
  const double allowed_m2 = tolerance * area_m2(land);
  std::vector<EdgeStrip> added;
  LandParts missed = missed_land(sprayed, land);
  for (int round = 0; round < most_rounds; ++round) {
    double left_m2 = area_m2(missed);
    if (left_m2 <= allowed_m2) break;
    std::vector<Stretch> stretches = stretches_of(missed, edges, widest_gap * swath_m);
    std::stable_sort(stretches.begin(), stretches.end(),
                     [](const Stretch& a, const Stretch& b) { return a.missed_m2 > b.missed_m2; });
    std::vector<GroundStrip> more;
    for (const Stretch& stretch : stretches) {
      if (left_m2 <= allowed_m2) break;
      for (const GroundStrip& strip :
           strips_beside(flight, edges[stretch.edge], stretch, swath_m, least_m)) {
        added.push_back({stretch.edge, strip});
        more.push_back(strip);
      }
      left_m2 -= stretch.missed_m2;
    }
    if (more.empty()) break;
    missed = missed_by(more, missed);
  }
  return chains_of(std::move(added), swath_m);
}

}  // namespace furrow::planner
