#include "planner/returns/continuous_bracket.hpp"

#include "planner/returns/evaluate.hpp"
#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"
#include "tests/planner/field_a_rows.hpp"

#include <catch2/catch.hpp>
#include <limits>

namespace furrow::planner {
namespace {

// Three strips of 10 m in three directions around the station, cells of 2 m, a way point on the
// first connection; returns replace connections of 9 m and 5 m.
ReturnProblem three_ways(double tank_m, double pack_s) {
  const Route route = end_to_end_route(
      metres(2), {end_strip({0, 1}, at_m(10, 0), at_m(10, 10), {}),
                  end_strip({0, 1}, at_m(6, 15), at_m(-2, 9), {at_m(10, 14), at_m(9, 15)}),
                  end_strip({0, 1}, at_m(-6, 6), at_m(-6, -4), {})});
  const Vehicle vehicle{.id = AgentId{1},
                        .home = at_m(12, 0),
                        .swath = metres(2),
                        .spray_speed = metres_per_second(1),
                        .ferry_speed = metres_per_second(2),
                        .spray_endurance = seconds(tank_m),
                        .flight_endurance = seconds(pack_s),
                        .battery_reserve = 0.0,
                        .tank = litres(10),
                        .min_turn_radius = metres(0),
                        .acceleration_limit = metres_per_second2(3),
                        .gnss = {}};
  const Station station{.id = StationId{1},
                        .position = at_m(0, 0),
                        .bays = 1,
                        .battery_swap = seconds(9),
                        .fill_base = seconds(1),
                        .fill_full = seconds(4)};
  return return_problem(route, {0, 15}, vehicle, station);
}

double least_by_enumeration_s(const ReturnProblem& p) {
  double least_s = std::numeric_limits<double>::infinity();
  for (std::uint32_t chosen = 0; chosen < 1u << 13; ++chosen) {
    Returns returns;
    for (std::uint32_t i = 0; i < 13; ++i) {
      if (chosen >> i & 1u) returns.push_back(i + 1);
    }
    const ReturnPlan plan = evaluated(p, returns);
    if (is_feasible(p, plan)) least_s = std::min(least_s, plan.non_spray_s);
  }
  return least_s;
}

TEST_CASE("return problem: a return at a strip's end replaces the connection", "[planner]") {
  const ReturnProblem p = three_ways(14, 1000);
  CHECK(p.fly_out_m == Approx(2.0));  // from (12, 0) to (10, 0)
  CHECK(p.spray_m[0] == Approx(2.0));
  CHECK(p.spray_m[4] == Approx(10.0));
  CHECK(p.back_m[4] == Approx(std::sqrt(200.0)));        // from (10, 10)
  CHECK(p.out_m[4] == Approx(std::sqrt(36.0 + 225.0)));  // to (6, 15)
  // (10, 10) (10, 14) (9, 15) (6, 15): 4 + sqrt(2) + 3 m at 2 m/s.
  CHECK(p.resume_s[4] - p.on_route_s[4] == Approx((7.0 + std::sqrt(2.0)) / 2.0));
  CHECK(p.on_route_s[5] - p.resume_s[4] == Approx(2.0));
  CHECK(p.out_m[2] == p.back_m[2]);  // mid-strip it resumes where it stopped
  CHECK(p.resume_s[2] == p.on_route_s[2]);
}

TEST_CASE("return problem: first way out, route and non-spray time are the mission's",
          "[planner]") {
  const ReturnProblem p = three_ways(14, 1000);
  const ReturnPlan plan = evaluated(p, {4, 8, 9});
  double flown_s = 0.0;
  for (const PlannedSortie& s : plan.sorties) {
    flown_s += s.fly_out_s + s.spray_s + s.fly_back_s + s.service_s;
  }
  CHECK(flown_s ==
        Approx(p.fly_out_m / 2.0 + p.on_route_s.back() + plan.non_spray_s + p.back_m.back() / 2.0));
}

TEST_CASE("exact: strips sprayed from end to end are split as enumeration splits them",
          "[planner]") {
  for (const double tank_m : {6.0, 9.0, 14.0, 22.0, 100.0}) {
    for (const double pack_s : {45.0, 60.0, 1000.0}) {
      const ReturnProblem p = three_ways(tank_m, pack_s);
      const auto exact = exact_plan(p);
      CAPTURE(tank_m, pack_s);
      REQUIRE(exact);
      CHECK(exact->proven);
      CHECK(exact->plan.non_spray_s == Approx(least_by_enumeration_s(p)));
      const auto simple = simple_plan(p), unplanned = unplanned_plan(p);
      CHECK(is_feasible(p, *simple));
      CHECK(is_feasible(p, *unplanned));
      CHECK(continuous_bracket(p)->lower_s <= exact->plan.non_spray_s);
    }
  }
}

TEST_CASE("continuous bracket: no plan on finer cells is below it", "[planner]") {
  const auto coarse = continuous_bracket(field_a_rows::problem(field_a_rows::route(metres(8))));
  const auto fine = continuous_bracket(field_a_rows::problem(field_a_rows::route(metres(1))));
  REQUIRE(coarse);
  REQUIRE(fine);
  CHECK(coarse->lower_s <= fine->upper.plan.non_spray_s);
  CHECK(fine->gap() < coarse->gap());
}

TEST_CASE("continuous bracket: fifty rows from one corner", "[planner]") {
  const Route route = field_a_rows::route(metres(0.5));
  double sprayed_m = 0.0;
  for (const Strip& s : route.strips) sprayed_m += distance(s.begin, s.end).base();
  CHECK(sprayed_m == Approx(34'600.0));  // half the area, 70 000 - 40 * 40 / 2 m2
  const ReturnProblem p = field_a_rows::problem(route);
  const auto bracket = continuous_bracket(p);
  REQUIRE(bracket);
  CHECK(bracket->upper.proven);
  CHECK(bracket->gap() <= 0.0005);
  CHECK(5.0 * bracket->mission_upper_s == Approx(37'208.0).epsilon(0.001));
  CHECK(5.0 * bracket->mission_upper_s == Approx(field_a_rows::flown_m(bracket->upper.plan)));
  CHECK(field_a_rows::flown_m(*unplanned_plan(p)) == Approx(45'811.0).epsilon(0.001));
}

TEST_CASE("continuous bracket: narrow at the cells that missions use", "[planner]") {
  const Route route = field_a_rows::route(metres(2));
  const ReturnProblem p = field_a_rows::problem(route);
  const auto bracket = continuous_bracket(route, p);
  const auto fine = continuous_bracket(field_a_rows::problem(field_a_rows::route(metres(0.5))));
  REQUIRE(bracket);
  REQUIRE(fine);
  CHECK(bracket->gap() <= 0.0005);
  CHECK(bracket->lower_s <= fine->upper.plan.non_spray_s);
  CHECK(bracket->lower_s >= fine->lower_s);
  CHECK(5.0 * bracket->mission_upper_s == Approx(37'208.0).epsilon(0.001));
}

}  // namespace
}  // namespace furrow::planner
