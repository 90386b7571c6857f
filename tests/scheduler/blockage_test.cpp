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

TEST_CASE("blockage: cells near the obstacle are cut out of their piece", "[scheduler]") {
  auto sorties = both_strips();
  // Within 3 m of y = 51: the centres from 49 to 53, which are cells 24 to 26. Held up before 22.
  const auto cut = cut_blocked(route, sorties, 22, std::vector{tree(51)});
  CHECK(cut == CellRange{24, 3});
  REQUIRE(sorties.size() == 1);
  const auto& pieces = sorties[0].pieces;
  REQUIRE(pieces.size() == 3);
  CHECK(pieces[0].cells == CellRange{0, 24});
  CHECK(pieces[0].to == route.centers[23]);
  CHECK(pieces[0].exit == route.centers[23]);
  CHECK(pieces[1].cells == CellRange{27, 23});
  CHECK(pieces[1].entry == route.centers[27]);
  CHECK(pieces[1].from == route.centers[27]);
  CHECK(pieces[1].exit == route.centers[49]);
  CHECK(pieces[2].cells == CellRange{50, 50});
}

TEST_CASE("blockage: a piece blocked to its end has nothing behind", "[scheduler]") {
  auto sorties = both_strips();
  // Within 3 m of y = 98: the centres 97 and 99.
  CHECK(cut_blocked(route, sorties, 45, std::vector{tree(98)}) == CellRange{48, 2});
  REQUIRE(sorties[0].pieces.size() == 2);
  CHECK(sorties[0].pieces[0].cells == CellRange{0, 48});
}

TEST_CASE("blockage: a sortie that is blocked as a whole is dropped", "[scheduler]") {
  auto sorties = both_strips();
  sorties[0].pieces.pop_back();
  std::vector<KeptObstacle> hedge;
  for (int i = 0; i < 50; ++i) hedge.push_back(tree(2.0 * i));
  CHECK(cut_blocked(route, sorties, 0, hedge) == CellRange{0, 50});
  CHECK(sorties.empty());
}

TEST_CASE("blockage: nothing is cut before an obstacle is known", "[scheduler]") {
  auto sorties = both_strips();
  CHECK_FALSE(cut_blocked(route, sorties, 30, {}));
  CHECK_FALSE(cut_blocked(route, sorties, 100, std::vector{tree(51)}));
  CHECK(sorties[0].pieces.size() == 2);
}

TEST_CASE("blockage: what no way leads to is cut away from the obstacle, then to the end",
          "[scheduler]") {
  auto sorties = both_strips();
  const std::vector one{tree(51)};
  // The centre of cell 30 is 10 m away: within 3 m and four cells. The next nearest widening, of
  // eight cells, takes what is within 19 m: cells 31 to 34. Nothing is near to the others.
  CHECK(cut_blocked(route, sorties, 30, one) == CellRange{30, 1});
  CHECK(cut_blocked(route, sorties, 31, one) == CellRange{31, 4});
  CHECK(cut_blocked(route, sorties, 35, one) == CellRange{35, 15});
  CHECK(sorties[0].pieces.size() == 2);
}

}  // namespace
}  // namespace furrow::scheduler
