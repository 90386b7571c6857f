#include "planner/coverage/swath/headland.hpp"

#include "planner/coverage/geos.hpp"

#include <algorithm>

namespace furrow::planner {
namespace {

constexpr double shortest_side_m = 1e-3;  // shorter sides come from rounding

StripGroup round_along(const RingM& ring, double half_width_m, bool backwards) {
  RingM corners;
  for (const PointM p : ring) {
    if (corners.empty() || norm(p - corners.back()) > shortest_side_m) corners.push_back(p);
  }
  if (backwards) std::reverse(corners.begin(), corners.end());
  // Begun in the middle of the longest side, so that every corner is turned with the valve open.
  std::size_t longest = 0;
  const auto side = [&](std::size_t i) { return corners[(i + 1) % corners.size()] - corners[i]; };
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (norm(side(i)) > norm(side(longest))) longest = i;
  }
  const PointM start = corners[longest] + 0.5 * side(longest);
  StripGroup group{{}, Flown::as_it_is};
  PointM here = start;
  for (std::size_t i = 1; i <= corners.size(); ++i) {
    const PointM next = corners[(longest + i) % corners.size()];
    group.strips.push_back({here, next, half_width_m});
    here = next;
  }
  group.strips.push_back({here, start, half_width_m});
  return group;
}

}  // namespace

Headland headland(const LandPart& flight, double swath_m, double margin_m, int passes,
                  HeadlandTurn turn) {
  Headland made;
  const bool backwards = turn == HeadlandTurn::clockwise;
  for (int pass = 0; pass < passes; ++pass) {
    const double depth_m = std::max(0.0, (pass + 0.5) * swath_m - margin_m);
    for (const LandPart& part : offset({flight}, -depth_m)) {
      // Around a hole, land on the left means clockwise: reversed, so that all rounds turn alike.
      made.rounds.push_back(round_along(part.outer, swath_m / 2, backwards));
      for (const RingM& hole : part.holes) {
        made.rounds.push_back(round_along(hole, swath_m / 2, !backwards));
      }
    }
  }
  made.inner = offset({flight}, -std::max(0.0, passes * swath_m - margin_m));
  return made;
}

}  // namespace furrow::planner
