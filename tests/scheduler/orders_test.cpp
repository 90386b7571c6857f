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

TEST_CASE("orders: the rest of a strip that another begins is entered over the cell before",
          "[scheduler]") {
  planner::Route route = comb(2, 5);
  route.strips[1].continues = false;
  route.strips[1].joins = at_m(3, 11);  // as if its first cell were the second of a strip
  const auto sorties = orders(route, uav_plan(route, 1, {1, 1}, {}));
  REQUIRE(sorties.size() == 1);
  CHECK(sorties[0].pieces[0].entry == at_m(3, 11));
  CHECK(sorties[0].pieces[0].from == route.centers[5]);
}

TEST_CASE("orders: each sortie ends where the plan says", "[scheduler]") {
  const planner::Route route = comb(2, 5);
  UavPlan uav = uav_plan(route, 1, {0, 2}, {4});
  CHECK(orders(route, uav)[1].station == StationId{1});
  uav.landings = {station(2), station(3)};
  const auto sorties = orders(route, uav);
  REQUIRE(sorties.size() == 2);
  CHECK(sorties[0].station == StationId{2});
  CHECK(sorties[1].station == StationId{3});
}

TEST_CASE("orders: strips sprayed from end to end are cut at the far edges of cells",
          "[scheduler]") {
  // North over five cells of 2 m, then east over five by a way point.
  const planner::Route route = planner::end_to_end_route(
      metres(2), {planner::end_strip({0, 1}, at_m(0, 0), at_m(0, 10), {}),
                  planner::end_strip({0, 1}, at_m(4, 14), at_m(14, 14), {at_m(0, 14)})});
  const auto sorties = orders(route, uav_plan(route, 1, {0, 2}, {2, 6}));
  REQUIRE(sorties.size() == 3);
  REQUIRE(sorties[0].pieces.size() == 1);
  CHECK(sorties[0].pieces[0].entry == at_m(0, 0));
  CHECK(sorties[0].pieces[0].to.y.base() == Approx(5.0));
  CHECK(sorties[0].pieces[0].exit.y.base() == Approx(6.0));
  REQUIRE(sorties[1].pieces.size() == 2);
  CHECK(sorties[1].pieces[0].entry == sorties[0].pieces[0].exit);
  CHECK(sorties[1].pieces[0].exit == at_m(0, 10));
  CHECK(sorties[1].pieces[0].approach.empty());
  CHECK(sorties[1].pieces[1].approach == std::vector{at_m(0, 14)});
  CHECK(sorties[1].pieces[1].entry == at_m(4, 14));
  CHECK(sorties[2].pieces[0].entry.x.base() == Approx(8.0));
  CHECK(sorties[2].pieces[0].approach.empty());  // straight from the station

  // A return at the end of the first strip: the next sortie begins with the second, straight.
  const auto at_end = orders(route, uav_plan(route, 1, {0, 2}, {4}));
  REQUIRE(at_end.size() == 2);
  CHECK(at_end[1].pieces[0].entry == at_m(4, 14));
  CHECK(at_end[1].pieces[0].approach.empty());
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
