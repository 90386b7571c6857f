#include "planner/coverage/swath/order.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow::planner;

namespace {

const LandPart meadow{{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}, {}};

StripGroup block(double west, double south, int rows) {
  StripGroup group;
  for (int r = 0; r < rows; ++r) {
    group.strips.push_back({{west, south + 2 * r}, {west + 20, south + 2 * r}, 1});
  }
  return group;
}

std::vector<StripGroup> scattered(int count) {
  std::vector<StripGroup> groups;
  for (int i = 0; i < count; ++i) {
    groups.push_back(block(40.0 * ((i * 7) % 23), 40.0 * ((i * 11) % 19), 1 + i % 3));
  }
  return groups;
}

// Every order and sense, by trial.
double best_by_trial_m(const std::vector<StripGroup>& groups) {
  std::vector<std::size_t> order(groups.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  double best = INFINITY;
  do {
    for (std::size_t senses = 0; senses < std::size_t{1} << 2 * groups.size(); ++senses) {
      PathM path;
      for (std::size_t i = 0; i < order.size(); ++i) {
        std::vector<GroundStrip> strips = groups[order[i]].strips;
        if ((senses >> 2 * i & 1) != 0) std::reverse(strips.begin(), strips.end());
        bool from_b = (senses >> 2 * i & 2) != 0;
        for (const GroundStrip& s : strips) {
          path.push_back(from_b ? s.b : s.a);
          path.push_back(from_b ? s.a : s.b);
          from_b = !from_b;
        }
      }
      best = std::min(best, length_m(path));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

}  // namespace

TEST_CASE("few groups are put into the best of all orders and senses") {
  const InsidePaths paths{meadow};
  for (const int count : {1, 2, 3, 4, 5}) {
    const std::vector<StripGroup> groups = scattered(count);
    const StripOrder order = strip_order(groups, paths, std::nullopt);
    CHECK(order.exact);
    CHECK(order.route_m == Approx(best_by_trial_m(groups)));
  }
}

TEST_CASE("many groups come within 15 % of the bound") {
  const InsidePaths paths{meadow};
  for (const int count : {10, 25, 60}) {
    const std::vector<StripGroup> groups = scattered(count);
    const StripOrder order = strip_order(groups, paths, std::nullopt);
    std::size_t strips = 0;
    for (const StripGroup& group : groups) strips += group.strips.size();
    CHECK(order.strips.size() == strips);
    CHECK(!order.exact);
    CHECK(order.route_m >= order.bound_m);
    CHECK(order.route_m <= 1.15 * order.bound_m);
  }
}

TEST_CASE("a route begins on the side of the start") {
  const InsidePaths paths{meadow};
  const StripOrder order = strip_order({block(100, 100, 20)}, paths, PointM{1000, 1000});
  CHECK(order.strips.front().strip.a == PointM{120, 138});
}

TEST_CASE("a chain is flown end to end from either end, a one-way round in its sense only") {
  const InsidePaths paths{meadow};
  const std::vector<GroundStrip> strips{{{100, 100}, {200, 100}, 1}, {{200, 100}, {300, 150}, 1}};
  const PointM east{400, 150};
  CHECK(strip_order({{strips, Flown::in_a_chain}}, paths, east).strips.front().strip.a ==
        PointM{300, 150});
  CHECK(strip_order({{strips, Flown::as_it_is}}, paths, east).strips.front().strip.a ==
        PointM{100, 100});
}
