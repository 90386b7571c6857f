#include "scheduler/takeover.hpp"

#include "scheduler/orders.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace furrow::scheduler {
namespace {

Survivor survivor(std::uint32_t id, double ready_s) {
  return {.vehicle = vehicle(id), .station = station(1), .ready_s = ready_s};
}

/// All cells of an addition, in the order flown.
std::vector<std::uint32_t> cells_of(const Addition& addition) {
  std::vector<std::uint32_t> cells;
  for (const Piece& piece : pieces(addition.sorties)) {
    for (std::uint32_t c = piece.cells.first; c < end(piece.cells); ++c) cells.push_back(c);
  }
  return cells;
}

TEST_CASE("takeover: every orphan goes to one survivor, and to nobody else", "[scheduler]") {
  const planner::Route route = comb(12, 50);
  const std::vector<CellRange> orphans{{20, 200}, {300, 250}};
  const std::vector<Survivor> three{survivor(1, 0), survivor(2, 0), survivor(3, 0)};
  const Takeover shared = take_over(route, orphans, three);
  CHECK(shared.nobodys.empty());
  std::vector<std::uint32_t> all;
  for (const Addition& addition : shared.additions) {
    const auto cells = cells_of(addition);
    CHECK_FALSE(cells.empty());
    all.insert(all.end(), cells.begin(), cells.end());
  }
  std::sort(all.begin(), all.end());
  REQUIRE(all.size() == 450);
  CHECK(all.front() == 20);
  CHECK(all[199] == 219);
  CHECK(all[200] == 300);
  CHECK(all.back() == 549);
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

TEST_CASE("takeover: who is ready late is given less", "[scheduler]") {
  const planner::Route route = comb(20, 50);
  const std::vector<CellRange> orphans{{0, 1000}};
  const std::vector<Survivor> two{survivor(1, 0), survivor(2, 200)};
  const Takeover shared = take_over(route, orphans, two);
  // 1000 moves of 2 m at 3 m/s are 667 s: 433 and 233 s of them end together.
  CHECK(cells_of(shared.additions[0]).size() == 650);
  CHECK(cells_of(shared.additions[1]).size() == 350);
  // By one who comes when all is done already, nothing.
  const std::vector<Survivor> far{survivor(1, 0), survivor(2, 2000)};
  CHECK(cells_of(take_over(route, orphans, far).additions[1]).empty());
}

TEST_CASE("takeover: a tank that does not last makes sorties", "[scheduler]") {
  Survivor small = survivor(1, 0);
  small.vehicle.spray_endurance = seconds(100);  // 300 m of 998
  const Takeover shared = take_over(comb(10, 50), std::vector{CellRange{0, 500}}, {{small}});
  CHECK(shared.additions[0].sorties.size() >= 4);
  CHECK(cells_of(shared.additions[0]).size() == 500);
}

TEST_CASE("takeover: who cannot reach is left out, and what nobody reaches is told",
          "[scheduler]") {
  const planner::Route route = comb(10, 50);
  const std::vector<CellRange> orphans{{100, 100}};
  Survivor lame = survivor(1, 0);
  lame.vehicle.flight_endurance = seconds(1);
  const std::vector<Survivor> one_lame{lame, survivor(2, 0)}, only_lame{lame};
  const Takeover shared = take_over(route, orphans, one_lame);
  CHECK(shared.additions[0].sorties.empty());
  CHECK(cells_of(shared.additions[1]).size() == 100);
  CHECK(take_over(route, orphans, only_lame).nobodys == orphans);
  CHECK(take_over(route, orphans, {}).nobodys == orphans);
}

}  // namespace
}  // namespace furrow::scheduler
