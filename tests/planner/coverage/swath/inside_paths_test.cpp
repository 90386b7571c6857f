#include "planner/coverage/swath/inside_paths.hpp"

#include "core/random.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow::planner;

namespace {

// A square of 10 m with a square hole of 2 m in its middle.
const LandPart holed{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}};

double shortest_m(const LandPart& part, PointM a, PointM b) {
  const auto path = InsidePaths{part}.shortest(a, b);
  REQUIRE(path);
  return length_m(*path);
}

}  // namespace

TEST_CASE("nothing between two places leaves the straight way") {
  CHECK(shortest_m(holed, {1, 1}, {9, 1}) == Approx(8));
}

TEST_CASE("a way bends around the corners of a hole") {
  // From (1, 5) to (9, 5) over (4, 6) and (6, 6): 2 x sqrt(9 + 1) + 2.
  CHECK(shortest_m(holed, {1, 5}, {9, 5}) == Approx(2 * std::sqrt(10) + 2));
}

TEST_CASE("a way may run along edges and through corners") {
  CHECK(shortest_m(holed, {4, 4}, {4, 6}) == Approx(2));
  CHECK(shortest_m(holed, {0, 0}, {0, 10}) == Approx(10));
  CHECK(shortest_m(holed, {2, 6}, {8, 6}) == Approx(6));
}

TEST_CASE("a way between the teeth of a comb goes round each tooth gap") {
  const LandPart comb{{{0, 0},
                       {50, 0},
                       {50, 30},
                       {40, 30},
                       {40, 10},
                       {30, 10},
                       {30, 30},
                       {20, 30},
                       {20, 10},
                       {10, 10},
                       {10, 30},
                       {0, 30}},
                      {}};
  // Straight down 20 m, 30 m along the floors of two gaps, and up 20 m.
  CHECK(shortest_m(comb, {10, 30}, {40, 30}) == Approx(20 + 30 + 20));
}

TEST_CASE("lengths to a line of places are those to each of them") {
  // Nine square posts of 4 m, 10 m apart: most places are reached past a corner, many past another
  // one than their neighbours.
  LandPart posts{{{0, 0}, {40, 0}, {40, 40}, {0, 40}}, {}};
  for (const double x : {8., 18., 28.}) {
    for (const double y : {8., 18., 28.}) {
      posts.holes.push_back({{x, y}, {x, y + 4}, {x + 4, y + 4}, {x + 4, y}});
    }
  }
  const InsidePaths paths{posts};
  furrow::Random random{1};
  const auto place = [&] { return PointM{40 * random.uniform(), 40 * random.uniform()}; };
  for (int round = 0; round < 300; ++round) {
    const InsidePaths::Fan fan = paths.fan(place());
    const PointM from = place(), to = place();
    std::vector<PointM> line;
    for (int i = 0; i <= 40; ++i) line.push_back(from + (i / 40.0) * (to - from));
    const std::vector<double> ways_m = paths.ways_m(fan, line);
    for (std::size_t i = 0; i < line.size(); ++i) {
      INFO("round " << round << ", place " << i);
      const double alone_m = paths.way_m(fan, line[i]);
      CHECK((ways_m[i] == alone_m || std::abs(ways_m[i] - alone_m) < 1e-9));
    }
    const auto by_fan = paths.way(fan, to), searched = paths.shortest(fan.from, to);
    REQUIRE(by_fan.has_value() == searched.has_value());
    if (!by_fan) continue;
    CHECK(length_m(*by_fan) == Approx(length_m(*searched)));
    CHECK(by_fan->front() == fan.from);
    CHECK(by_fan->back() == to);
    for (std::size_t i = 1; i < by_fan->size(); ++i) {
      CHECK(paths.edges().sees((*by_fan)[i - 1], (*by_fan)[i]));
    }
  }
  CHECK(paths.ways_m(paths.fan({1, 1}), {}).empty());
}

TEST_CASE("places off the land have no way") {
  CHECK(!InsidePaths{holed}.shortest({5, 5}, {1, 1}));
  CHECK(!InsidePaths{holed}.shortest({1, 1}, {11, 1}));
}
