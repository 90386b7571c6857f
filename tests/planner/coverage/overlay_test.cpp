#include "planner/coverage/overlay.hpp"

#include "core/random.hpp"
#include "planner/coverage/geos.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

using namespace furrow;
using namespace furrow::planner;

namespace {

LandPart square(double x, double y, double side) {
  return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, {}};
}

std::map<Overlay::Counts, double> measured(const Overlay& overlay) {
  std::map<Overlay::Counts, double> areas;
  overlay.measure([&](const Overlay::Counts& n, double area_m2) { areas[n] += area_m2; });
  return areas;
}

// A star around a place: always simple, rarely convex.
LandPart star(Random& random) {
  const PointM at{random.uniform(0, 60), random.uniform(0, 60)};
  LandPart made;
  constexpr int corners = 9;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners, reach = random.uniform(3, 20);
    made.outer.push_back(at + reach * PointM{std::cos(angle), std::sin(angle)});
  }
  return made;
}

}  // namespace

TEST_CASE("an overlay of two squares has a corner of 2 m by 2 m under both") {
  for (const RowFrame frame : {RowFrame{1, 0}, RowFrame::along({0, 1}), RowFrame::along({2, 1})}) {
    Overlay overlay{frame};
    overlay.add(square(0, 0, 5), 0);
    overlay.add(square(3, 3, 5), 1);
    const auto areas = measured(overlay);
    REQUIRE(areas.size() == 3);
    CHECK(areas.at({1, 0, 0}) == Approx(25 - 4));
    CHECK(areas.at({0, 1, 0}) == Approx(25 - 4));
    CHECK(areas.at({1, 1, 0}) == Approx(4));
  }
}

TEST_CASE("an overlay leaves out holes, whichever way round rings run") {
  LandPart part = square(0, 0, 100);
  part.holes.push_back(square(40, 40, 20).outer);
  for (const bool is_turned : {false, true}) {
    if (is_turned) std::reverse(part.holes[0].begin(), part.holes[0].end());
    Overlay overlay{{1, 0}};
    overlay.add(part, 2);
    const auto areas = measured(overlay);
    REQUIRE(areas.size() == 1);
    CHECK(areas.at({0, 0, 1}) == Approx(10000 - 400));
  }
}

TEST_CASE("an overlay counts what polygons of one kind share as often as they do") {
  Overlay overlay{{1, 0}};
  for (const double x : {0.0, 1.0, 2.0}) overlay.add(square(x, 0, 3), 0);
  const auto areas = measured(overlay);
  // Under one from 0 to 1 and 4 to 5, under two from 1 to 2 and 3 to 4, under three from 2 to 3.
  CHECK(areas.at({1, 0, 0}) == Approx(6));
  CHECK(areas.at({2, 0, 0}) == Approx(6));
  CHECK(areas.at({3, 0, 0}) == Approx(3));
}

TEST_CASE("an overlay agrees with GEOS on a hundred heaps of stars and rows") {
  Random random{4};
  for (int heap = 0; heap < 100; ++heap) {
    LandParts stars, rows;
    for (int i = 0; i < 8; ++i) stars.push_back(star(random));
    // Rows that share their edges.
    for (int i = 0; i < 10; ++i) {
      const double y = 6.0 * i;
      rows.push_back({{{0, y}, {60, y}, {60, y + 6}, {0, y + 6}}, {}});
    }
    Overlay overlay{RowFrame::along({1, random.below(2) == 0 ? 0.0 : random.uniform(-1, 1)})};
    for (const LandPart& s : stars) overlay.add(s, 0);
    for (const LandPart& r : rows) overlay.add(r, 1);
    double once_m2 = 0, sum_m2 = 0, both_m2 = 0, rows_m2 = 0;
    overlay.measure([&](const Overlay::Counts& n, double area_m2) {
      once_m2 += n[0] > 0 ? area_m2 : 0;
      sum_m2 += n[0] * area_m2;
      both_m2 += n[0] > 0 && n[1] > 0 ? area_m2 : 0;
      rows_m2 += n[1] * area_m2;
    });
    const LandParts all = united(stars);
    CHECK(sum_m2 == Approx(area_m2(stars)).epsilon(1e-9));
    CHECK(once_m2 == Approx(area_m2(all)).epsilon(1e-6));
    CHECK(rows_m2 == Approx(3600).epsilon(1e-9));
    const double outside_m2 = area_m2(subtracted(all, united(rows)));
    CHECK(both_m2 == Approx(area_m2(all) - outside_m2).epsilon(1e-6));
  }
}
