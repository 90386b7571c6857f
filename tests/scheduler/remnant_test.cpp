#include "scheduler/remnant.hpp"

#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

TEST_CASE("remnant: strips are cut to what is left, and know their old cells", "[scheduler]") {
  const planner::Route whole = comb(4, 10);
  const std::vector<CellRange> runs{{7, 5}, {30, 10}};
  const Remnant left = remnant(whole, runs);
  CHECK(left.cells ==
        std::vector<std::uint32_t>{7, 8, 9, 10, 11, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39});
  REQUIRE(left.route.strips.size() == 3);
  for (std::size_t i = 0; i < left.cells.size(); ++i) {
    CHECK(left.route.centers[i] == whole.centers[left.cells[i]]);
  }
  const planner::Strip& cut = left.route.strips[0];
  CHECK(cut.cells == CellRange{0, 3});
  CHECK(cut.begin == whole.centers[7]);
  CHECK(cut.end == whole.centers[9]);
  CHECK_FALSE(planner::sprays_ends(cut));
  CHECK(left.route.strips[1].continues);        // 9 to 10 is the sprayed move that it was
  CHECK_FALSE(left.route.strips[2].continues);  // 11 to 30 is a ferry
}

TEST_CASE("remnant: a strip sprayed from end to end is cut at the edges of its cells",
          "[scheduler]") {
  const planner::Route whole = planner::end_to_end_route(
      metres(2), {planner::end_strip({0, 1}, at_m(0, 0), at_m(0, 20), {}),
                  planner::end_strip({0, 1}, at_m(2, 20), at_m(2, 0), {at_m(1, 21)})});
  const std::vector<CellRange> runs{{4, 2}, {8, 4}};
  const Remnant left = remnant(whole, runs);
  REQUIRE(left.route.strips.size() == 3);
  CHECK(left.route.strips[0].begin == FieldPoint{at_m(0, 8)});
  CHECK(left.route.strips[0].end == FieldPoint{at_m(0, 12)});
  CHECK(left.route.strips[1].end == FieldPoint{at_m(0, 20)});
  CHECK(left.route.strips[2].approach == std::vector<FieldPoint>{at_m(1, 21)});
  CHECK(planner::cell_length(left.route, left.route.strips[0]).base() == Approx(2.0));
}

TEST_CASE("remnant: runs are taken in the order given", "[scheduler]") {
  const planner::Route whole = comb(3, 4);
  const std::vector<CellRange> runs{{8, 4}, {0, 6}};
  const Remnant flown = remnant(whole, runs);
  CHECK(flown.cells == std::vector<std::uint32_t>{8, 9, 10, 11, 0, 1, 2, 3, 4, 5});
  REQUIRE(flown.route.strips.size() == 3);
  CHECK_FALSE(flown.route.strips[1].continues);  // 11 to 0 is a ferry
  CHECK(flown.route.strips[2].continues);        // 3 to 4 is the sprayed move that it was
}

TEST_CASE("remnant: runs that touch are joined", "[scheduler]") {
  CHECK(joined({{5, 2}, {0, 3}, {3, 1}}) == std::vector<CellRange>{{0, 4}, {5, 2}});
}

}  // namespace
}  // namespace furrow::scheduler
