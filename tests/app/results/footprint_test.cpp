#include "app/results/footprint.hpp"

#include "app/results/ways.hpp"
#include "tests/app/results/small_mission.hpp"

#include <catch2/catch.hpp>

namespace furrow::app {
namespace {

FootprintFigures small_footprint(double first_m, double second_m, double third_m) {
  const MissionRecord record = small_plan();
  std::vector<Pass> passes;
  for (std::uint32_t i = 0; i < 4; ++i) passes.push_back({i, first_m});
  for (std::uint32_t i = 4; i < 8; ++i) passes.push_back({i, second_m});
  for (std::uint32_t i = 8; i < 12; ++i) passes.push_back({i, third_m});
  return footprint(record.scenario.field, record.plan.route, passes, 0);
}

TEST_CASE("footprint: on the lines everything is wetted once", "[app]") {
  const FootprintFigures f = small_footprint(0, 0, 0);
  CHECK(f.wetted_m2 == Approx(48.0));
  CHECK(f.missed_m2 == Approx(0.0).margin(1e-9));
  CHECK(f.overlap_m2 == Approx(0.0).margin(1e-9));
  CHECK(f.outside_m2 == Approx(0.0).margin(1e-9));
}

TEST_CASE("footprint: strips flown to and fro shift to opposite sides", "[app]") {
  // Strip 1 flies north: 0.5 right is east, [0.5, 2.5]. Strip 2 flies south: 0.5 right is west,
  // [1.5, 3.5]. Strip 3 stays, [4, 6]. Each over 8 m: dry 0.5 + 0.5 m, twice 1 m, outside nothing.
  const FootprintFigures f = small_footprint(0.5, 0.5, 0);
  CHECK(f.missed_m2 == Approx(8.0));
  CHECK(f.overlap_m2 == Approx(8.0));
  CHECK(f.wetted_m2 == Approx(40.0));
  CHECK(f.outside_m2 == Approx(0.0).margin(1e-9));
}

TEST_CASE("footprint: what reaches over the boundary is outside", "[app]") {
  // Strip 1 shifted by 0.25 to the west: [-0.25, 1.75]; a quarter metre outside over 8 m.
  const FootprintFigures f = small_footprint(-0.25, 0, 0);
  CHECK(f.outside_m2 == Approx(2.0));
  CHECK(f.missed_m2 == Approx(2.0));
  CHECK(f.overlap_m2 == Approx(0.0).margin(1e-9));
}

TEST_CASE("footprint: ground passed twice is overlap, ground not passed is missed", "[app]") {
  const MissionRecord record = small_plan();
  const std::vector<Pass> passes{{0, 0.0}, {0, 0.0}};
  const FootprintFigures f = footprint(record.scenario.field, record.plan.route, passes, 0);
  CHECK(f.wetted_m2 == Approx(4.0));
  CHECK(f.overlap_m2 == Approx(4.0));
  CHECK(f.missed_m2 == Approx(44.0));  // 11 of 12 cells
}

TEST_CASE("ways: only what lies beyond an edge is outside, holes and obstacles included", "[app]") {
  MissionRecord record = small_plan();
  record.scenario.field = {.boundary = {at_m(0, 0), at_m(60, 0), at_m(60, 40), at_m(0, 40)},
                           .holes = {{at_m(20, 10), at_m(30, 10), at_m(30, 20), at_m(20, 20)}},
                           .obstacles = {{"tree", at_m(45, 30), metres(2)}}};
  // Edges are widened by 0.1 m on either side.
  CHECK(outside_m(record, {{at_m(50, 5), at_m(70, 5)}}) == Approx(9.9));
  CHECK(outside_m(record, {{at_m(0, 0.05), at_m(0, -0.05), at_m(60, -0.05)}}) == 0.0);
  CHECK(outside_m(record, {{at_m(10, 15), at_m(40, 15)}}) == Approx(9.8));
  // A round obstacle is a polygon of 32 corners around it.
  CHECK(outside_m(record, {{at_m(45, 20), at_m(45, 39)}}) == Approx(3.8).margin(0.05));
}

}  // namespace
}  // namespace furrow::app
