#include "planner/fleet/bay_bound.hpp"
#include "planner/fleet/priced_bays.hpp"
#include "planner/fleet/priced_split.hpp"

#include <catch2/catch.hpp>

#include <vector>

namespace furrow::planner::fleet {
namespace {

TEST_CASE("an aircraft earns the most by the flights that pay for their time in bays") {
  // Flights of 1, 2, 3 slots at 1, 4, 5; a service of 2 slots.
  PricedAircraft aircraft;
  const std::vector<double> flights{1, 4, 5}, sprayed{0.25, 0.5, 1.0};
  const auto most = [&](const Slots& time, double tank, double bay) {
    const std::vector<double> bays(time.slots, bay);
    return aircraft.most(time,
                         {.flights = flights, .sprayed = sprayed, .tank = tank, .bays = bays});
  };
  // Bays for nothing: three flights of 2 slots with two services in between take 10 slots, less
  // one for each flight that ends within a slot.
  CHECK(most({8, 2}, 0, 0) == 12);
  CHECK(aircraft.earned().flights == std::vector<double>{0, 3, 0});
  // At 3 a slot a service does not pay.
  CHECK(most({8, 2}, 0, 3) == 5);
  CHECK(aircraft.earned().bays == std::vector<double>(8, 0.0));
  // At 1.5 a slot one does: two flights of 3 slots, less 3.
  CHECK(most({8, 2}, 0, 1.5) == 7);
}

TEST_CASE("an aircraft fills what it sprays, but for its first flight") {
  // Flights of 1, 2, 3 slots spray 0.25, 0.5 and 1 tank, at 8 a tank; a service of 2 slots, 2 more
  // to fill a tank.
  PricedAircraft aircraft;
  const std::vector<double> flights{0, 0, 0}, sprayed{0.25, 0.5, 1.0}, free(9, 0.0), dear(9, 2.0);
  const auto most = [&](std::size_t slots, const std::vector<double>& bays) {
    return aircraft.most(
        {slots, 2, 2.0},
        {.flights = flights, .sprayed = sprayed, .tank = 8, .bays = std::span{bays}.first(slots)});
  };
  CHECK(most(3, free) == 8);
  // A first flight of 3 slots lands in slot 2; a service, one slot of filling or a little more, and
  // a flight of 3 slots end with slot 8 only; without that slot half a tank is filled, and sprayed
  // in 2 slots.
  CHECK(most(8, free) == 16);
  CHECK(most(7, free) == 12);
  CHECK(aircraft.earned().tanks == 1.5);
  // At 2 a slot of a bay half a tank costs 4 and earns 4, a whole one costs 6 and earns 8.
  CHECK(most(8, dear) == 10);
  CHECK(aircraft.earned().bays == std::vector<double>{0, 0, 1, 1, 1, 0, 0, 0});
}

TEST_CASE("the cheapest split pays for the fewest or for the shortest flights") {
  // 100 m along x from the station; 1 m/s; tanks of 60 m.
  FleetProblem p{StripPath{{{at_m(0, 0), at_m(100, 0)}}}, {}, {{at_m(0, 0), 1, 10.0}}};
  p.fliers.assign(1, {.tank_m = 60, .spray_mps = 1, .ferry_mps = 1, .start = at_m(0, 0)});
  PricedSplit split{p, 10.0, 0.5};
  std::vector<double> counts(split.levels());
  // A sortie ending at x takes 2 x. The farthest takes 200 s, all others up to it less.
  REQUIRE(split.levels() == 20);
  CHECK(split.least(std::vector<double>(20, 1.0), counts) == 2);
  // By the second: from 40 m, 80 s, to the end, 200 s.
  std::vector<double> by_time(20);
  for (std::size_t j = 0; j < 20; ++j) by_time[j] = 10.0 * static_cast<double>(j + 1);
  CHECK(split.least(by_time, counts) == Approx(280));
}

/// So many equal rows of 100 m at the station, one tank each, flown in about 100 s.
FleetProblem rows(std::uint32_t count, std::uint32_t fliers, std::uint32_t bays, double service_s) {
  std::vector<StraightStrip> strips;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool back = i % 2 == 1;
    strips.push_back({at_m(0, back ? 1e-3 : 0), at_m(50, back ? 1e-3 : 0)});
    strips.push_back({at_m(50, back ? 1e-3 : 0), at_m(0, back ? 1e-3 : 0)});
  }
  FleetProblem p{StripPath{strips}, {}, {{at_m(0, 0), bays, service_s}}};
  p.fliers.assign(fliers, {.tank_m = 100, .spray_mps = 1, .ferry_mps = 1, .start = at_m(0, 0)});
  return p;
}

TEST_CASE("a bay that all must pass holds the fleet up") {
  // Four aircraft, eight full tanks: all land at 100 s, the last of four is served until 300 s.
  // The work alone is 800 s of flights and 200 s of services, by four: 250 s.
  const FleetProblem p = rows(8, 4, 1, 50);
  const double bound_s = bay_bound_s(p, 250);
  CHECK(bound_s > 390);
  CHECK(bound_s <= 400);
  // Filling, 30 s for a tank, is done in the bay as well: the last of four is served until 420 s.
  // Who comes earlier has sprayed less and leaves more to fill.
  FleetProblem filled = p;
  filled.depots[0].fill_s = 30;
  const double filled_s = bay_bound_s(filled, 250);
  CHECK(filled_s > 430);
  CHECK(filled_s <= 520);
  // Four bays hold nobody up.
  CHECK(bay_bound_s(rows(8, 4, 4, 50), 249) == 249);
}

}  // namespace
}  // namespace furrow::planner::fleet
