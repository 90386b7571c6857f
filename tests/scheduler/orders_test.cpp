#include "scheduler/orders.hpp"

#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

TEST_CASE("orders: a sortie has a piece for each strip it touches", "[scheduler]") {
  const planner::Route route = comb(4, 10);
  // Strips 1 and 2, cells 10 .. 29; back after the 7th cell of the share (cell 16).
  const auto sorties = orders(route, uav_plan(route, 1, {1, 2}, {6}));

  REQUIRE(sorties.size() == 2);
  REQUIRE(sorties[0].pieces.size() == 1);
  CHECK(sorties[0].pieces[0].cells == CellRange{10, 7});
  // The share starts afresh though its strip continues the one before, which is another's.
  CHECK(sorties[0].pieces[0].entry == route.centers[10]);
  CHECK(sorties[0].pieces[0].to == route.centers[16]);
  REQUIRE(sorties[1].pieces.size() == 2);
  CHECK(sorties[1].pieces[0].cells == CellRange{17, 3});
  CHECK(sorties[1].pieces[0].entry == route.centers[16]);  // resumes where it stopped
  CHECK(sorties[1].pieces[0].from == route.centers[17]);
  CHECK(sorties[1].pieces[1].cells == CellRange{20, 10});
  CHECK(sorties[1].pieces[1].entry == route.centers[19]);  // the sprayed move between strips
}

TEST_CASE("orders: a strip reached by a ferry starts afresh", "[scheduler]") {
  planner::Route route = comb(2, 5);
  route.strips[1].continues = false;
  const auto sorties = orders(route, uav_plan(route, 1, {0, 2}, {}));
  REQUIRE(sorties.size() == 1);
  REQUIRE(sorties[0].pieces.size() == 2);
  CHECK(sorties[0].pieces[1].entry == route.centers[5]);
}

TEST_CASE("orders: the pieces of all shares cover every cell once, in order", "[scheduler]") {
  const planner::Route route = comb(7, 13);
  std::uint32_t next = 0;
  for (const UavPlan& uav : {uav_plan(route, 1, {0, 3}, {0, 12, 13, 20, 37}),
                             uav_plan(route, 2, {3, 0}, {}), uav_plan(route, 3, {3, 4}, {25})}) {
    for (const Piece& piece : pieces(orders(route, uav))) {
      CHECK(piece.cells.first == next);
      CHECK(piece.cells.count > 0);
      CHECK(piece.from == route.centers[piece.cells.first]);
      CHECK(piece.to == route.centers[end(piece.cells) - 1]);
      next = end(piece.cells);
    }
  }
  CHECK(next == 7 * 13);
}

}  // namespace
}  // namespace furrow::scheduler
