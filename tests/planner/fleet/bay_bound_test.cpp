#include "planner/fleet/bay_bound.hpp"
#include "planner/fleet/priced_bays.hpp"
#include "planner/fleet/priced_split.hpp"

#include <catch2/catch.hpp>

#include <vector>

namespace furrow::planner::fleet {
namespace {

TEST_CASE("an aircraft earns the most by the flights and services that pay") {
  // Flights of 1, 2, 3 slots at 1, 4, 5; a service of 2 slots.
  PricedAircraft aircraft;
  std::vector<double> flights{1, 4, 5}, services(8, 0.0), flown(3), served(8);
  // Services for nothing: three flights of 2 slots with two services in between take 10 slots, less
  // one for each flight that ends within a slot.
  CHECK(aircraft.most({8, 2}, flights, services, flown, served) == 12);
  CHECK(flown == std::vector<double>{0, 3, 0});
  // At a price of 6 a service does not pay.
  services.assign(8, 6.0);
  CHECK(aircraft.most({8, 2}, flights, services, flown, served) == 5);
  CHECK(served == std::vector<double>(8, 0.0));
}

TEST_CASE("a bay earns the most by services that do not overlap") {
  PricedBay bay;
  std::vector<double> counts(6);
  // Services of 2 slots: in slots 0, 2 and 4, 1 + 4 + 1, or in 1 and 3, 3 + 3.
  CHECK(bay.most({6, 2}, std::vector<double>{1, 3, 4, 3, 1, 9}, counts) == 6);
  // The last slot is too late for a service of 2.
  CHECK(counts[5] == 0);
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
  // Four bays hold nobody up.
  CHECK(bay_bound_s(rows(8, 4, 4, 50), 249) == 249);
}

}  // namespace
}  // namespace furrow::planner::fleet
