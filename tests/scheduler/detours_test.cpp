#include "scheduler/detours.hpp"

#include "planner/returns/evaluate.hpp"
#include "scheduler/flight_times.hpp"
#include "scheduler/remnant.hpp"
#include "scheduler/takeover.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

// Two strips of 100 m, 4 m apart, in cells of 4 m.
planner::Route two_strips() {
  return planner::end_to_end_route(metres(4),
                                   {planner::end_strip({0, 1}, at_m(2, 0), at_m(2, 100), {}),
                                    planner::end_strip({0, 1}, at_m(6, 100), at_m(6, 0), {})});
}

// 3 m clear of a tree of 1 m.
planner::Room with_tree(double x_m, double y_m) { return planner::Room{{{{x_m, y_m}, 4}}, {}, {}}; }

// As short as can be: the valve stays open.
std::vector<planner::MetDetour> around(const planner::Room& room) {
  return detours(two_strips(), room, metres(4), {.length = 1, .area = 0});
}

planner::MetDetour sum(const std::vector<planner::MetDetour>& all) {
  planner::MetDetour whole;
  for (const planner::MetDetour& d : all) whole = whole + d;
  return whole;
}

}  // namespace

TEST_CASE("detours: a tree on a strip adds the closed formula's metres where the way turns off",
          "[scheduler]") {
  // R_z = R = 4, L_d = 0: theta = arccos(4 / 8) = 60 degrees, dx = sqrt(64 - 16) = 6.93, and
  // 2 8 pi / 3 - 2 6.93 = 2.90 m more. The other strip is just clear of the circle.
  const auto found = around(with_tree(2, 50));
  REQUIRE(found.size() == 50);
  CHECK(sum(found).longer_m == Approx(16 * M_PI / 3 - 2 * std::sqrt(48.0)).margin(1e-6));
  // It leaves the line at 50 - 6.93 = 43.1 m, in cell 10.
  CHECK(found[10].longer_m == Approx(sum(found).longer_m));
  CHECK(around(with_tree(40, 50)).empty());
}

TEST_CASE("detours: tank and clock count them from their cell on, in remnants too", "[scheduler]") {
  planner::Route route = two_strips();
  const auto plain = planner::cell_stops(route, {0, 50});
  route.detours.resize(50);
  route.detours[10] = {.longer_m = 3, .sprayed_m = 3};   // valve open
  route.detours[40] = {.longer_m = 3, .sprayed_m = -9};  // 12 m around with the valve closed
  const auto stops = planner::cell_stops(route, {0, 50});
  CHECK(stops[9].spray_m == plain[9].spray_m);
  CHECK(stops[10].spray_m == Approx(plain[10].spray_m + 3));
  CHECK(stops[39].dry_m == 0);
  CHECK(stops[49].spray_m == Approx(plain[49].spray_m + 3 - 9));
  CHECK(stops[49].dry_m == Approx(12));
  CHECK(planner::cell_stops(route, {11, 5}).back().spray_m == Approx(20));
  const std::vector<CellRange> runs{{30, 5}, {8, 6}};
  const Remnant left = remnant(route, runs);
  REQUIRE(left.route.detours.size() == 11);
  CHECK(left.route.detours[5 + 2].longer_m == 3);
}

TEST_CASE("detours: a sortie takes as much longer as they take to fly", "[scheduler]") {
  planner::Route route = two_strips();
  const Vehicle v = vehicle(1);
  const Station depot = station(1);
  const auto flight_s = [&](const planner::Returns& returns, std::size_t sortie) {
    const auto problem = planner::return_problem(route, {0, 50}, v, depot);
    const FlightTimes times{route, problem};
    return times(planner::evaluated(problem, returns).sorties[sortie], sortie == 0).until_sprayed_s;
  };
  const double plain_s = flight_s({}, 0), before_s = flight_s({29}, 0), after_s = flight_s({29}, 1);
  route.detours = around(with_tree(2, 50));
  const double more_s = sum(route.detours).longer_m / v.spray_speed.base();
  CHECK(flight_s({}, 0) - plain_s == Approx(more_s));
  CHECK(flight_s({29}, 0) - before_s == Approx(more_s));
  CHECK(flight_s({29}, 1) == Approx(after_s));
}

TEST_CASE("detours: who takes over work around obstacles is foreseen to land later",
          "[scheduler]") {
  planner::Route route = two_strips();
  const std::vector<CellRange> all{{0, 50}};
  const std::vector<Survivor> survivors{{vehicle(1), station(1), 100}};
  const auto lands_s = [&] { return take_over(route, all, survivors).additions[0].lands_s; };
  const double plain_s = lands_s();
  route.detours.resize(50);
  route.detours[10] = {.longer_m = 30, .sprayed_m = -10};
  CHECK(lands_s() - plain_s == Approx(30 / vehicle(1).spray_speed.base()));
}

}  // namespace furrow::scheduler
