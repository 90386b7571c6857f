#include "planner/fleet/till_empty.hpp"
#include "planner/fleet/queue_clock.hpp"
#include "tests/planner/fleet/yardsticks.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner::fleet {
namespace {

TEST_CASE("flying till empty takes as long as published for field A") {
  for (const yardsticks::Yardstick& y : yardsticks::all) {
    const FleetProblem p = yardsticks::problem(y);
    const auto sorties = till_empty(p);
    REQUIRE(sorties);
    // 34 600 m / 2222 m: 15.6 tanks.
    CHECK(sorties->size() == 16);
    CHECK(QueueClock{p}.finish(*sorties).makespan_s == Approx(y.till_empty_s).margin(0.6));
  }
}

/// One strip of 100 m along x, a station at its begin, speed 1 m/s.
FleetProblem two_fliers(double tank_m) {
  FleetProblem p{StripPath{{{at_m(0, 0), at_m(100, 0)}}}, {}, {{at_m(0, 0), 1, 10.0}}};
  p.fliers.assign(2, {.tank_m = tank_m, .spray_mps = 1, .ferry_mps = 1, .start = at_m(0, 0)});
  return p;
}

TEST_CASE("the first to come is the first to be served, and others wait") {
  const FleetProblem p = two_fliers(50);
  // Lands at 50; the other sprays 25 .. 50, home at 100. The first is out again at 60.
  const Timetable apart = QueueClock{p}.timetable(
      FleetSorties{{0, 25, 0, 0}, {25, 50, 1, 0}, {50, 75, 0, 0}, {75, 100, 1, 0}});
  CHECK(apart.lands_s == std::vector<double>{50, 100, 60 + 150, 110 + 200});
  CHECK(apart.wait_s == 0);
  CHECK(apart.makespan_s == 310);
  // 210 + 310 s in all, of them 100 s spraying.
  CHECK(apart.non_spray_s == 420);

  // Both land at 100, the second waits for 10 s.
  const Timetable together = QueueClock{p}.timetable(
      FleetSorties{{0, 50, 0, 0}, {40, 50, 1, 0}, {50, 75, 0, 0}, {75, 100, 1, 0}});
  CHECK(together.wait_s == 10);
  CHECK(together.leaves_s == std::vector<double>{0, 0, 110, 120});
}

TEST_CASE("packs that are too short for a tank end sorties, and places beyond reach are refused") {
  FleetProblem p = two_fliers(100);
  for (Flier& f : p.fliers) f.pack_s = 202;
  const auto whole = till_empty(p);
  REQUIRE(whole);
  CHECK(whole->size() == 1);
  p.fliers[0].pack_s = 120;  // 60 m there and back
  const auto shared = till_empty(p);
  REQUIRE(shared);
  CHECK((*shared)[0].to_m == Approx(60).margin(1e-3));
  p.fliers[1].pack_s = 120;
  CHECK_FALSE(till_empty(p));
}

TEST_CASE("simple plans return at the station's side only") {
  const FleetProblem p = yardsticks::problem(yardsticks::all[0]);
  const auto sorties = simple_sorties(p);
  REQUIRE(sorties);
  // Rows to and fro from the station's side: two or none in a sortie, 700 m each at first.
  for (const Sortie& s : *sorties) {
    if (s.to_m < p.path.length_m()) CHECK(p.path.strip_to(s.to_m) % 2 == 1);
  }
  CHECK((*sorties)[0].to_m == Approx(1400));
}

}  // namespace
}  // namespace furrow::planner::fleet
