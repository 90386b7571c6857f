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
  // 1000 moves of 2 m at 3 m/s are 667 s: 433 and 233 s of them end together, but for what turns
  // and ways add, a tenth at most. Strips are cut for it.
  CHECK(cells_of(shared.additions[0]).size() == Approx(650).epsilon(0.1));
  CHECK(cells_of(shared.additions[0]).size() + cells_of(shared.additions[1]).size() == 1000);
  CHECK(std::abs(shared.additions[0].lands_s - shared.additions[1].lands_s) < 20);
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

TEST_CASE("takeover: queues at the bay are foreseen, the same each time", "[scheduler]") {
  // Three aircraft, ready at the same time at one bay, with tanks of 100 m for 800 m: cut into
  // equal runs they would come home together, and two would wait for 60 s, time and again.
  std::vector<Survivor> three{survivor(1, 50), survivor(2, 50), survivor(3, 50)};
  for (Survivor& s : three) s.vehicle.spray_endurance = seconds(100.0 / 3);
  const planner::Route route = comb(8, 50);
  const std::vector<CellRange> orphans{{0, 400}};
  const Takeover shared = take_over(route, orphans, three);
  const Takeover again = take_over(route, orphans, three);
  double latest_s = 0.0;
  std::size_t cells = 0;
  for (std::size_t i = 0; i < three.size(); ++i) {
    latest_s = std::max(latest_s, shared.additions[i].lands_s);
    cells += cells_of(shared.additions[i]).size();
    CHECK(cells_of(again.additions[i]) == cells_of(shared.additions[i]));
    CHECK(shared.additions[i].station.id == StationId{1});
  }
  CHECK(cells == 400);
  // Spraying is 800 m / 3 m/s / 3 = 89 s for each; five fills at least follow one another at the
  // bay, of 60 s each for a tank. Eight in a row behind a first sortie of 40 s are 520 s.
  CHECK(latest_s > 50 + 89);
  CHECK(latest_s < 50 + 40 + 8 * 60);
}

TEST_CASE("takeover: free bays where no survivor goes so far are used", "[scheduler]") {
  // As above: one bay holds three aircraft up, which three more beside it do not.
  std::vector<Survivor> three{survivor(1, 50), survivor(2, 50), survivor(3, 50)};
  for (Survivor& s : three) s.vehicle.spray_endurance = seconds(100.0 / 3);
  const planner::Route route = comb(8, 50);
  const std::vector<CellRange> orphans{{0, 400}};
  const std::vector<Station> free{station(2, 3)};
  const auto last_s = [](const Takeover& shared) {
    double latest_s = 0.0;
    for (const Addition& a : shared.additions) latest_s = std::max(latest_s, a.lands_s);
    return latest_s;
  };
  const Takeover with = take_over(route, orphans, three, {}, free);
  CHECK(last_s(with) < last_s(take_over(route, orphans, three)) - 60);
  std::size_t elsewhere = 0, cells = 0;
  for (const Addition& a : with.additions) {
    cells += cells_of(a).size();
    for (const SortieOrder& sortie : a.sorties) elsewhere += sortie.station == StationId{2};
  }
  CHECK(cells == 400);
  CHECK(elsewhere > 0);
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
