#include "planner/returns/evaluate.hpp"

#include "planner/returns/cost.hpp"
#include "planner/returns/exact.hpp"
#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"
#include "tests/planner/paper_case.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

// Two strips of three cells with a ferry between them: (1, 1) to (1, 5), then (9, 1) to (9, 5).
Route route_with_ferry() {
  Route route{.cell = metres(2),
              .centers = {at_m(1, 1), at_m(1, 3), at_m(1, 5), at_m(9, 1), at_m(9, 3), at_m(9, 5)},
              .strips = {},
              .missed = {}};
  route.strips = {centre_strip({0, 3}, at_m(1, 1), at_m(1, 5), false),
                  centre_strip({3, 3}, at_m(9, 1), at_m(9, 5), false)};
  return route;
}

TEST_CASE("problem: a ferry takes time and sprays nothing", "[planner]") {
  const ReturnProblem p =
      return_problem(route_with_ferry(), {0, 6}, paper_case::vehicle(), paper_case::station());

  CHECK(p.spray_m == std::vector<double>{0, 2, 4, 4, 6, 8});
  CHECK(p.strip_starts == std::vector<std::uint32_t>{0, 3});
  // Four metres at 3 m/s, then hypot(8, 4) = 8.944 m at 6 m/s.
  CHECK_THAT(p.on_route_s[3], WithinAbs(4.0 / 3.0 + 8.94427 / 6.0, 1e-5));
  CHECK_THAT(p.back_m[3], WithinAbs(9.05539, 1e-5));  // hypot(9, 1)
  CHECK(p.fly_out_m == 0.0);                          // it stands on the first cell
}

TEST_CASE("problem: a share begins within a strip and counts from its own first cell",
          "[planner]") {
  const ReturnProblem p =
      return_problem(route_with_ferry(), {1, 3}, paper_case::vehicle(), paper_case::station());

  CHECK(p.spray_m == std::vector<double>{0, 2, 2});
  CHECK(p.strip_starts == std::vector<std::uint32_t>{0, 2});
  CHECK_THAT(p.fly_out_m, WithinAbs(2.0, 1e-12));  // from (1, 1) to (1, 3)
}

TEST_CASE("evaluate: one return costs its round trip and the longer of filling and swapping",
          "[planner]") {
  Vehicle vehicle = paper_case::vehicle();
  vehicle.spray_endurance = seconds(2);  // D_max = 6 m
  const ReturnProblem p =
      return_problem(route_with_ferry(), {0, 6}, vehicle, paper_case::station());

  // Home from (1, 5): hypot(1, 5) = 5.099 m; out to (9, 1): hypot(9, 1) = 9.055 m, in place of a
  // ferry of 8.944 m. The second sortie sprays 4 m of 6 m: T_p = 20 + 40 * 4 / 6 = 46.667 s.
  const ReturnPlan kept = evaluated(p, {2});
  CHECK(is_feasible(p, kept));
  CHECK(kept.swaps == 0);
  CHECK_THAT(kept.round_trips_m, WithinAbs(5.09902 + 9.05539, 1e-4));
  const double ways_s = (5.09902 + 9.05539 - 8.94427) / 6;
  CHECK_THAT(kept.non_spray_s, WithinAbs(ways_s + 46.66667, 1e-4));
  CHECK(kept.sorties[1].pack == 1);
  CHECK(kept.sorties[1].service_s == 0.0);

  // First sortie: 4 / 3 + 5.099 / 6 = 2.183 s. Second: 9.055 / 6 + 4 / 3 + hypot(9, 5) / 6 =
  // 4.559 s. A pack for 6.5 s does not carry both, so it is swapped: 60 s.
  vehicle.flight_endurance = seconds(6.5);
  const ReturnProblem tight =
      return_problem(route_with_ferry(), {0, 6}, vehicle, paper_case::station());
  const ReturnPlan swapped = evaluated(tight, {2});
  CHECK(is_feasible(tight, swapped));
  CHECK(swapped.swaps == 1);
  CHECK(swapped.sorties[1].pack == 2);
  CHECK_THAT(swapped.non_spray_s, WithinAbs(ways_s + 60.0, 1e-4));
  CHECK_THAT(swapped.sorties[1].battery_used, WithinAbs(4.559 / 6.5, 1e-3));
}

TEST_CASE("evaluate: as flown, packs are swapped by what flights lose and are to be sure of",
          "[planner]") {
  // Sorties of 2.183 s and 4.559 s as above, which lose 5 s and 1 s. Before the second the pack has
  // given 7.183 s and has to be good for 1.005 * 5.559 + 6 = 11.587 s more: 18.770 s in all.
  Vehicle vehicle = paper_case::vehicle();
  const auto swaps = [&](double pack_s) {
    vehicle.flight_endurance = seconds(pack_s);
    const ReturnProblem p =
        return_problem(route_with_ferry(), {0, 6}, vehicle, paper_case::station());
    const ReturnPlan plan = evaluated_as_flown(std::vector{&p, &p}, {2}, std::vector{5.0, 1.0});
    CHECK_THAT(plan.sorties[1].battery_used, WithinAbs(5.559 / pack_s, 1e-3));
    return plan.swaps;
  };
  CHECK(swaps(18.8) == 0);
  CHECK(swaps(18.7) == 1);
}

TEST_CASE("evaluate: sorties may end at different stations", "[planner]") {
  // Home from (1, 5) to (1, 11), 6 m at 6 m/s; there 20 s and 40 s of a tank for 4 m of its 2700 m;
  // out to the next strip at (9, 1); home from (9, 5) to (9, 0).
  const Route route = route_with_ferry();
  Station north = paper_case::station(), south = paper_case::station();
  north.position = at_m(1, 11);
  south.position = at_m(9, 0);
  const auto to_north = return_problem(route, {0, 6}, paper_case::vehicle(), north);
  const auto to_south = return_problem(route, {0, 6}, paper_case::vehicle(), south);
  const ReturnPlan plan = evaluated(std::vector{&to_north, &to_south}, {2});
  REQUIRE(plan.sorties.size() == 2);
  CHECK(plan.sorties[0].fly_back_s == 1.0);
  CHECK_THAT(plan.sorties[1].fly_out_s, WithinAbs(std::hypot(8, 10) / 6, 1e-9));
  CHECK_THAT(plan.sorties[1].fly_back_s, WithinAbs(5.0 / 6, 1e-9));
  CHECK_THAT(plan.sorties[0].service_s, WithinAbs(20 + 40 * 4.0 / 2700, 1e-9));
  CHECK_THAT(plan.round_trips_m, WithinAbs(6 + std::hypot(8, 10), 1e-9));
  // Of the non-spray time the ferry that it replaces is no part.
  CHECK_THAT(plan.non_spray_s,
             WithinAbs(1 + 20 + 160.0 / 2700 + std::hypot(8, 10) / 6 - std::hypot(8, 4) / 6, 1e-9));
  CHECK(evaluated(to_north, {2}).non_spray_s ==
        evaluated(std::vector{&to_north, &to_north}, {2}).non_spray_s);
}

TEST_CASE("evaluate: the reserve of a pack is never planned with", "[planner]") {
  Vehicle vehicle = paper_case::vehicle();
  vehicle.flight_endurance = seconds(10);
  const auto feasible = [&](double reserve) {
    vehicle.battery_reserve = reserve;
    const ReturnProblem p =
        return_problem(route_with_ferry(), {0, 6}, vehicle, paper_case::station());
    return is_feasible(p, evaluated(p, {}));
  };
  // All in one sortie: 8 / 3 + 8.944 / 6 + hypot(9, 5) / 6 = 5.873 s.
  CHECK(feasible(0.41));
  CHECK_FALSE(feasible(0.42));
}

TEST_CASE("plans: every strategy says which limit leaves no plan", "[planner]") {
  const Route route = route_with_ferry();
  Vehicle vehicle = paper_case::vehicle();
  Station station = paper_case::station();

  SECTION("a tank for less than a cell") {
    vehicle.spray_endurance = seconds(0.5);  // 1.5 m of a 2 m move
    const ReturnProblem p = return_problem(route, {0, 6}, vehicle, station);
    CHECK(unplanned_plan(p).error().fault == PlanFault::tank_too_small);
    CHECK(simple_plan(p).error().fault == PlanFault::tank_too_small);
    CHECK(exact_plan(p).error().fault == PlanFault::tank_too_small);
    CHECK(unplanned_plan(p, Counting::straight_moves).error().fault == PlanFault::tank_too_small);
    CHECK_THAT(exact_plan(p).error().detail, Contains("UAV 1: cell 1 takes 2.0 m"));
  }
  SECTION("a station beyond one pack") {
    station.position = at_m(-6000, 0);  // 1000 s one way
    const ReturnProblem p = return_problem(route, {0, 6}, vehicle, station);
    CHECK(unplanned_plan(p).error().fault == PlanFault::out_of_reach);
    CHECK(simple_plan(p).error().fault == PlanFault::out_of_reach);
    CHECK(exact_plan(p).error().fault == PlanFault::out_of_reach);
    CHECK_THAT(exact_plan(p).error().detail, Contains("from station 1 and back"));
  }
}

}  // namespace
}  // namespace furrow::planner
