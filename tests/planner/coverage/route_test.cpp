#include "planner/coverage/route.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

// 7 m along 3:4, then straight over to 5 m along -x by a way point.
Route bent() {
  return end_to_end_route(metres(2), {end_strip({0, 1}, at_m(0, 0), at_m(4.2, 5.6), {}),
                                      end_strip({0, 1}, at_m(6, 10), at_m(1, 10), {at_m(6, 5.6)})});
}

TEST_CASE("route: a strip sprayed from end to end is divided into equal cells", "[planner]") {
  const Route route = bent();
  // 7 / 2 = 3.5 rounds to 4 cells of 1.75 m, 5 / 2 = 2.5 to 3 of 5 / 3 m.
  REQUIRE(route.strips.size() == 2);
  CHECK(route.strips[0].cells == CellRange{0, 4});
  CHECK(route.strips[1].cells == CellRange{4, 3});
  CHECK(cell_length(route, route.strips[0]).base() == Approx(1.75));
  CHECK(cell_length(route, route.strips[1]).base() == Approx(5.0 / 3.0));
  CHECK(distance(route.strips[0].begin, route.centers[0]).base() == Approx(0.875));
  CHECK(distance(route.centers[1], route.centers[2]).base() == Approx(1.75));
  CHECK(route.strips[1].to == route.centers[6]);
  CHECK(route.strips[1].to.x.base() == Approx(1.0 + 5.0 / 6.0));
  CHECK(strip_of(route, 3) == 0);
  CHECK(strip_of(route, 4) == 1);
}

TEST_CASE("route: stops lie on far edges and resume at the next strip", "[planner]") {
  const Route route = bent();
  const auto stops = cell_stops(route, {0, 7});
  CHECK(stops[1].stop.x.base() == Approx(2.1));  // half of 4.2
  CHECK(stops[1].resume == stops[1].stop);
  CHECK(stops[3].stop == at_m(4.2, 5.6));
  CHECK(stops[3].resume == at_m(6, 10));
  CHECK(stops[3].skipped_m == Approx(1.8 + 4.4));
  CHECK(stops[4].approach_m == Approx(1.8 + 4.4));
  CHECK(stops[6].spray_m == Approx(12.0));
  CHECK(resume_point(route, 3) == at_m(6, 10));
  CHECK(resume_point(route, 6) == at_m(1, 10));
}

TEST_CASE("route: a part of it counts from its own beginning", "[planner]") {
  const auto stops = cell_stops(bent(), {2, 3});
  CHECK(stops[0].spray_m == Approx(1.75));
  CHECK(stops[0].approach_m == 0.0);
  CHECK(stops[2].spray_m == Approx(3.5 + 5.0 / 3.0));
}

}  // namespace
}  // namespace furrow::planner
