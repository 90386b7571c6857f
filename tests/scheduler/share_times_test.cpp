#include "scheduler/share_times.hpp"

#include "planner/returns/evaluate.hpp"
#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

// A pack that never needs a swap and a tank of 20 m: 10 moves of 2 m.
Vehicle thirsty(std::uint32_t id) {
  Vehicle v = vehicle(id);
  v.spray_endurance = metres(20) / v.spray_speed;
  v.flight_endurance = seconds(1e9);
  return v;
}

double finish_s(const planner::ReturnProblem& p, const planner::Returns& returns) {
  return p.fly_out_m / p.vehicle.ferry_speed.base() + p.on_route_s.back() +
         planner::evaluated(p, returns).non_spray_s;
}

TEST_CASE("share_times: the time is the best over all choices of return points", "[scheduler]") {
  planner::Route route = comb(3, 5);
  route.strips[2].continues = false;
  const std::vector stations{station(1, 1, at_m(4, -3))};
  const RouteLengths lengths = route_lengths(route, stations);
  const Vehicle v = thirsty(1);
  FirstFlights flights{route};
  const Pace p = pace(flights, v, stations[0], lengths.home_m[0]);
  const auto problem = planner::return_problem(route, {0, 15}, v, stations[0]);

  // All 2^13 choices among cells 1 .. 13; cell 0 is sprayed before take-off counts a move.
  double best_s = 1e9;
  for (std::uint32_t mask = 0; mask < 1u << 13; ++mask) {
    planner::Returns returns;
    for (std::uint32_t c = 0; c < 13; ++c) {
      if (mask >> c & 1u) returns.push_back(c + 1);
    }
    if (planner::is_feasible(problem, planner::evaluated(problem, returns))) {
      best_s = std::min(best_s, finish_s(problem, returns));
    }
  }

  GrowingShare share{route, lengths, p, 0};
  share.grow();
  share.grow();
  CHECK(share.grow() == Approx(best_s).margin(1e-9));
  CHECK(finish_s(problem, share.returns()) == Approx(best_s).margin(1e-9));
  CHECK_FALSE(share.can_grow());
}

TEST_CASE("share_times: the time does not fall as a share grows, nor rise as it starts later",
          "[scheduler]") {
  const planner::Route route = comb(12, 30);
  const std::vector stations{station(1, 1, at_m(10, 20))};
  const RouteLengths lengths = route_lengths(route, stations);
  Vehicle v = vehicle(1);
  v.spray_endurance = metres(100) / v.spray_speed;
  const Pace p = fastest_pace(route, std::span{&v, 1}, stations, lengths.nearest_m);
  std::vector<double> from_earlier(route.strips.size(), 1e9);
  for (std::uint32_t first = 0; first < route.strips.size(); ++first) {
    GrowingShare share{route, lengths, p, first};
    double last_s = 0.0;
    for (std::uint32_t s = first; share.can_grow(); ++s) {
      const double grown_s = share.grow();
      CHECK(grown_s >= last_s);
      CHECK(grown_s <= from_earlier[s] + 1e-9);
      from_earlier[s] = last_s = grown_s;
    }
  }
}

TEST_CASE("share_times: no plan of the planner's is faster", "[scheduler]") {
  const planner::Route route = comb(20, 350);
  const std::vector stations{station(1)};
  const RouteLengths lengths = route_lengths(route, stations);
  const Vehicle v = vehicle(1);
  FirstFlights flights{route};
  const Pace p = pace(flights, v, stations[0], lengths.home_m[0]);
  GrowingShare share{route, lengths, p, 0};
  double best_s = 0.0;
  while (share.can_grow()) best_s = share.grow();
  const auto problem = planner::return_problem(route, {0, 20 * 350}, v, stations[0]);
  CHECK(best_s <= finish_s(problem, planner::unplanned_plan(problem)->returns));
  CHECK(best_s <= finish_s(problem, planner::simple_plan(problem)->returns));
}

}  // namespace
}  // namespace furrow::scheduler
