#include "planner/coverage/swath/swath_route.hpp"

#include <catch2/catch.hpp>

using namespace furrow;
using namespace furrow::planner;

TEST_CASE("strips become runs of equal cells about one swath long") {
  // 10.8 x 4 m at 2 m: two rows of five cells of 2.16 m.
  const Field field{{at_m(0, 0), at_m(10.8, 0), at_m(10.8, 4), at_m(0, 4)}, {}, {}};
  const auto coverage = swath_coverage(field, metres(2), {.direction_deg = 90, .near = at_m(0, 0)});
  REQUIRE(coverage);
  const Route route = swath_route(*coverage, metres(2));
  REQUIRE(route.centers.size() == 10);
  CHECK(route.centers[0].x.base() == Approx(1.08));
  CHECK(distance(route.centers[3], route.centers[4]).base() == Approx(2.16));
  REQUIRE(route.strips.size() == 2);
  CHECK(route.strips[1].cells == CellRange{5, 5});
  CHECK(route.strips[1].from == route.centers[5]);
  // The turn at the eastern end is straight, from the end of one row to the beginning of the next.
  CHECK(route.strips[0].end.x.base() == Approx(10.8));
  CHECK(route.strips[1].begin.y.base() == Approx(3));
  CHECK(route.strips[1].approach.empty());
}
