#include "planner/ferry/aprons.hpp"

#include "planner/coverage/geos.hpp"
#include "planner/coverage/swath/edge_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow::planner {
namespace {

constexpr int corners = 32;
constexpr double reach_over = 1.5;  // of the distance to the land
constexpr double overlap_m = 0.05;  // so that what is joined overlaps and does not just touch
constexpr double half_bridge_m = 0.1;

struct Gap {
  PointM from, to;
  double length_m;
};

// Ways between two outlines, each from a vertex of one to the nearest place of the other.
std::vector<Gap> gaps_between(const LandPart& a, const LandPart& b) {
  std::vector<Gap> gaps;
  const auto from_vertices = [&](const LandPart& from, const LandPart& to) {
    for (const PointM p : from.outer) {
      Gap best{p, p, INFINITY};
      each_edge(to, [&](PointM u, PointM v) {
        const PointM q = nearest_on(p, u, v);
        if (norm(q - p) < best.length_m) best = {p, q, norm(q - p)};
      });
      gaps.push_back(best);
    }
  };
  from_vertices(a, b);
  from_vertices(b, a);
  std::stable_sort(gaps.begin(), gaps.end(),
                   [](const Gap& x, const Gap& y) { return x.length_m < y.length_m; });
  return gaps;
}

LandPart bridge_over(const Gap& gap) {
  const PointM along = gap.length_m > 0 ? (1 / gap.length_m) * (gap.to - gap.from) : PointM{1, 0};
  const PointM from = gap.from - overlap_m * along, to = gap.to + overlap_m * along;
  const PointM left = half_bridge_m * PointM{-along.y, along.x};
  return {{from - left, to - left, to + left, from + left}, {}};
}

}  // namespace

LandParts apron(PointM stand, const LandParts& land) {
  double away_m = INFINITY;
  for (const LandPart& part : land) {
    if (EdgeGrid{part}.contains(stand)) return {};
    each_edge(part, [&](PointM a, PointM b) {
      away_m = std::min(away_m, norm(nearest_on(stand, a, b) - stand));
    });
  }
  const double radius_m = (reach_over * away_m + overlap_m) / std::cos(std::numbers::pi / corners);
  LandPart disc;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    disc.outer.push_back(stand + radius_m * PointM{std::cos(angle), std::sin(angle)});
  }
  return {disc};
}

LandParts with_necks(const LandParts& flight, const LandParts& land, const LandParts& taken,
                     double margin_m) {
  LandParts joined = flight;
  for (const double share : {0.5, 0.25, 0.1, 0.01}) {
    if (joined.size() < 2) break;
    const LandParts wide = subtracted(offset(land, -share * margin_m), taken);
    const double gap_m = (1 - share) * margin_m + overlap_m;
    // Grown back, the parts are all of `wide` but for necks.
    for (const LandPart& neck : subtracted(wide, offset(flight, gap_m))) {
      const LandParts grown = offset({neck}, gap_m + overlap_m);
      LandParts more = joined;
      for (LandPart& part : subtracted(wide, subtracted(wide, grown))) {
        more.push_back(std::move(part));
      }
      more = united(more);
      if (more.size() < joined.size()) joined = std::move(more);
    }
  }
  return joined;
}

LandParts bridges(const LandParts& land, const LandParts& taken) {
  LandParts made;
  std::vector<std::size_t> joined{0}, apart;
  for (std::size_t i = 1; i < land.size(); ++i) apart.push_back(i);
  while (!apart.empty()) {
    Gap best{{}, {}, INFINITY};
    std::size_t nearest = apart.front();
    for (const std::size_t i : joined) {
      for (const std::size_t j : apart) {
        for (const Gap& gap : gaps_between(land[i], land[j])) {
          if (gap.length_m >= best.length_m) break;
          const LandPart over = bridge_over(gap);
          if (area_m2(subtracted({over}, taken)) < (1 - 1e-9) * area_m2(over)) continue;
          best = gap;
          nearest = j;
          break;
        }
      }
    }
    if (best.length_m < INFINITY) made.push_back(bridge_over(best));
    joined.push_back(nearest);
    apart.erase(std::find(apart.begin(), apart.end(), nearest));
  }
  return made;
}

}  // namespace furrow::planner
