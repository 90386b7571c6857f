#include "scheduler/blockage.hpp"

#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

// Strips of 50 cells of 2 m; the first goes north along x = 1, its cell c at y = 2 c + 1.
const planner::Route route = comb(2, 50);

std::vector<SortieOrder> both_strips() {
  SortieOrder sortie{.pieces = {}, .station = StationId{1}};
  for (const planner::Strip& s : route.strips) {
    sortie.pieces.push_back(
        {.cells = s.cells, .entry = s.from, .from = s.from, .to = s.to, .exit = s.to});
  }
  return {sortie};
}

KeptObstacle tree(double y_m) { return {{at_m(1, y_m), metres(1)}, metres(2)}; }

TEST_CASE("blockage: cells up to behind the obstacle are cut out of their piece", "[scheduler]") {
  auto sorties = both_strips();
  // Within 3 m of y = 51: the centres from 49 to 53, which are cells 24 to 26. Held up before 22.
  const auto cut = cut_blocked(route, sorties, 22, std::vector{tree(51)});
  CHECK(cut == CellRange{22, 5});
  REQUIRE(sorties.size() == 1);
  const auto& pieces = sorties[0].pieces;
  REQUIRE(pieces.size() == 3);
  CHECK(pieces[0].cells == CellRange{0, 22});
  CHECK(pieces[0].to == route.centers[21]);
  CHECK(pieces[0].exit == route.centers[21]);
  CHECK(pieces[1].cells == CellRange{27, 23});
  CHECK(pieces[1].entry == route.centers[27]);
  CHECK(pieces[1].from == route.centers[27]);
  CHECK(pieces[1].exit == route.centers[49]);
  CHECK(pieces[2].cells == CellRange{50, 50});
}

TEST_CASE("blockage: a piece blocked to its end has nothing behind", "[scheduler]") {
  auto sorties = both_strips();
  CHECK(cut_blocked(route, sorties, 45, std::vector{tree(98)}) == CellRange{45, 5});
  REQUIRE(sorties[0].pieces.size() == 2);
  CHECK(sorties[0].pieces[0].cells == CellRange{0, 45});
}

TEST_CASE("blockage: a sortie that is blocked as a whole is dropped", "[scheduler]") {
  auto sorties = both_strips();
  sorties[0].pieces.pop_back();
  CHECK(cut_blocked(route, sorties, 0, std::vector{tree(98)}) == CellRange{0, 50});
  CHECK(sorties.empty());
}

TEST_CASE("blockage: what no way leads to is cut to the end, but not before an obstacle is known",
          "[scheduler]") {
  auto sorties = both_strips();
  CHECK_FALSE(cut_blocked(route, sorties, 30, {}));
  CHECK_FALSE(cut_blocked(route, sorties, 100, std::vector{tree(51)}));
  CHECK(sorties[0].pieces.size() == 2);
  CHECK(cut_blocked(route, sorties, 30, std::vector{tree(51)}) == CellRange{30, 20});
}

}  // namespace
}  // namespace furrow::scheduler
