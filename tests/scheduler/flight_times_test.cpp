#include "scheduler/flight_times.hpp"

#include "planner/returns/evaluate.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace furrow::scheduler {
namespace {

// One strip of cells 2 m apart along +y from (1, 1).
struct Case {
  planner::Route route;
  planner::ReturnProblem problem;
  std::vector<SortieTimes> flown(const planner::Returns& returns) const {
    const FlightTimes times{route, problem};
    std::vector<SortieTimes> all;
    for (const auto& s : planner::evaluated(problem, returns).sorties) {
      all.push_back(times(s, all.empty()));
    }
    return all;
  }
};

Case comb_case(std::uint32_t strips, std::uint32_t cells, const Vehicle& v, FieldPoint station_at) {
  planner::Route route = comb(strips, cells);
  auto problem = planner::return_problem(route, {0, strips * cells}, v, station(1, 1, station_at));
  return {std::move(route), std::move(problem)};
}

// 2 m/s2 are planned with, whatever the share kept for corrections.
Vehicle with_two_mps2() {
  Vehicle v = vehicle(1);
  v.acceleration_limit = (2.0 / planned_acceleration(v).base()) * v.acceleration_limit;
  v.home = at_m(1, -100);
  return v;
}

TEST_CASE("flight times: a straight way takes its ramps as well", "[scheduler]") {
  const Case c = comb_case(1, 51, with_two_mps2(), at_m(1, 201));
  const auto flown = c.flown({});
  // Out over 101 m: 3 s up to 6 m/s over 9 m, down to 3 m/s over (36 - 9) / 4 = 6.75 m in 1.5 s,
  // 85.25 m at 6 m/s. Then 100 m at 3 m/s.
  CHECK(flown[0].until_sprayed_s == Approx(3 + 1.5 + 85.25 / 6 + 100.0 / 3));
  // Home over 100 m: 6.75 m in 1.5 s, 9 m in 3 s, 84.25 m at 6 m/s.
  CHECK(flown[0].home_s == Approx(4.5 + 84.25 / 6));
}

TEST_CASE("flight times: a way too short for full speed is a triangle", "[scheduler]") {
  Vehicle v = with_two_mps2();
  v.home = at_m(1, 1);
  const Case c = comb_case(1, 2, v, at_m(1, 5));
  // 4 m from rest to rest at 2 m/s2: 2 sqrt(4 / 2) s, half of it to the middle.
  const auto flown = c.flown({});
  CHECK(flown[0].until_sprayed_s == Approx(std::sqrt(2.0)));
  CHECK(flown[0].home_s == Approx(std::sqrt(2.0)));
}

TEST_CASE("flight times: a change of strips is a half circle, braked for", "[scheduler]") {
  Vehicle v = with_two_mps2();
  v.home = at_m(1, -100);
  const Case one = comb_case(1, 51, v, at_m(1, -100));
  const Case two = comb_case(2, 51, v, at_m(3, -100));
  // Of radius 1 m, at sqrt(0.9 * 2 * 1) = 1.3416 m/s: pi / 1.3416 = 2.3416 s for 4 m, which take
  // 4 / 3 s at constant speed; braking and getting faster cost (3 - 1.3416)^2 / (2 * 2 * 3) each.
  const double change_s = 3.141592653589793 / std::sqrt(1.8) - 4.0 / 3.0 +
                          2.0 * std::pow(3.0 - std::sqrt(1.8), 2) / 12.0;
  const double out_s = 3 + 1.5 + 85.25 / 6;
  const auto flown = two.flown({});
  CHECK(flown[0].until_sprayed_s == Approx(out_s + 202.0 / 3 + change_s));
  CHECK(one.flown({})[0].until_sprayed_s < flown[0].until_sprayed_s);
}

TEST_CASE("flight times: work goes on from the last sprayed cell", "[scheduler]") {
  // A station straight below the strip: out and home need no turn but at the return point, where
  // the aircraft stops.
  Vehicle v = with_two_mps2();
  const Case c = comb_case(1, 101, v, at_m(1, -99));
  const auto flown = c.flown({50});
  // Up to the return at 101 m: braking from 3 m/s to a stop costs 1.5 s over 2.25 m.
  CHECK(flown[0].until_sprayed_s == Approx(3 + 1.5 + 85.25 / 6 + 97.75 / 3 + 1.5));
  CHECK(flown[0].home_s == Approx(200.0 / 6 + 3));
  CHECK(flown[1].until_sprayed_s == Approx(3 + 1.5 + (200 - 15.75) / 6 + 97.75 / 3 + 1.5));
  CHECK(flown[1].home_s == Approx(300.0 / 6 + 3));
}

TEST_CASE("flight times: a sortie from one station to another has a way of each", "[scheduler]") {
  const Case south = comb_case(1, 40, vehicle(1), at_m(0, 0));
  const planner::ReturnProblem north =
      planner::return_problem(south.route, {0, 40}, vehicle(1), station(2, 1, at_m(0, 100)));
  const FlightTimes both{south.route, std::vector{&south.problem, &north}};
  const auto sorties = planner::evaluated(south.problem, {19}).sorties;
  const FlightTimes from_south{south.route, south.problem}, from_north{south.route, north};
  const SortieTimes across = both(sorties[1], false, {.from = 0, .to = 1});
  // It does not turn round at the end: as on the way to the north, from where it sets out.
  CHECK(across.until_sprayed_s < from_south(sorties[1], false).until_sprayed_s);
  CHECK(across.home_s == Approx(from_north(sorties[1], false).home_s));
  CHECK(both(sorties[1], false).home_s == from_south(sorties[1], false).home_s);
}

}  // namespace
}  // namespace furrow::scheduler
