#include "scheduler/joint_plan.hpp"

#include "planner/at_once.hpp"
#include "scheduler/orders.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <cmath>
#include <numbers>
#include <set>
#include <thread>

namespace furrow::scheduler {
namespace {

planner::SolveSettings settings(planner::ReturnStrategy returns) {
  return {.returns = returns,
          .refine = true,
          .paper_counting = false,
          .iterations = 20,
          .masses = 10,
          .budget_s = 1,
          .seed = 1};
}

/// Aircraft whose tanks last for 24 m, 12 cells.
std::vector<Vehicle> small_fleet(std::uint32_t count) {
  std::vector<Vehicle> fleet;
  for (std::uint32_t i = 1; i <= count; ++i) {
    fleet.push_back(vehicle(i));
    fleet.back().spray_endurance = seconds(8.0);
  }
  return fleet;
}

std::vector<Station> two_stations() {
  return {station(1, 1, at_m(0, 0)), station(2, 1, at_m(16, 0))};
}

/// Whether every cell of a route is in one list, once.
bool is_whole(const SortieLists& lists, std::size_t cells) {
  std::set<std::uint32_t> seen;
  std::size_t count = 0;
  for (const auto& list : lists) {
    for (const CellSortie& s : list) {
      count += s.cells.count;
      for (std::uint32_t c = s.cells.first; c < end(s.cells); ++c) seen.insert(c);
    }
  }
  return count == cells && seen.size() == cells && *seen.rbegin() + 1 == cells;
}

TEST_CASE("path model: positions and cells of strips turn into one another", "[scheduler]") {
  const planner::Route route = comb(3, 5);  // each strip lasts for 10 m, five cells
  const auto model = search_model(route, small_fleet(1), two_stations(), {});
  REQUIRE(model);
  CHECK(model->path.length_m() == Approx(30.0));
  for (std::uint32_t cells = 0; cells <= 15; ++cells) {
    CHECK(position_m(route, model->path, cells) == Approx(2.0 * cells));
    CHECK(cells_before(route, model->path, 2.0 * cells) == cells);
  }
  CHECK(cells_before(route, model->path, 4.9) == 2);
  CHECK(cells_before(route, model->path, 5.1) == 3);
}

TEST_CASE("path model: no plan for tanks of four cells, nor on surveys", "[scheduler]") {
  auto fleet = small_fleet(1);
  fleet[0].spray_endurance = seconds(8.0 / 3);  // 8 m
  CHECK_FALSE(search_model(comb(3, 5), fleet, two_stations(), {}));
  planner::Route survey = comb(3, 5);
  survey.cell = {};
  CHECK_FALSE(search_model(survey, small_fleet(1), two_stations(), {}));
}

TEST_CASE("joint plan: cuts move to cells that the tank lasts for, and back", "[scheduler]") {
  const planner::Route route = comb(4, 6);  // 24 cells, 48 m
  const auto model = search_model(route, small_fleet(2), two_stations(), {});
  REQUIRE(model);
  // 23.2 m lies 0.6 of a cell behind the 11th; 12 cells are a tank. The third is of one cell at
  // most, which the fourth takes.
  const planner::fleet::FleetSorties sorties{{.from_m = 0, .to_m = 23.2, .flier = 0, .depot = 0},
                                             {.from_m = 23.2, .to_m = 40, .flier = 1, .depot = 1},
                                             {.from_m = 40, .to_m = 41, .flier = 0, .depot = 0},
                                             {.from_m = 41, .to_m = 48, .flier = 0, .depot = 1}};
  const SortieLists lists = cell_sorties(route, *model, sorties);
  REQUIRE(lists.size() == 2);
  REQUIRE(lists[0].size() == 2);
  REQUIRE(lists[1].size() == 1);
  CHECK(lists[0][0].cells == CellRange{0, 12});
  CHECK(lists[1][0].cells == CellRange{12, 8});
  CHECK(lists[0][1].cells == CellRange{20, 4});
  CHECK(lists[0][1].station == 1);
  CHECK(is_whole(lists, 24));
  CHECK(is_whole(cell_sorties(route, *model, model_sorties(route, *model, lists)), 24));
}

TEST_CASE("joint plan: lists are flown from station to station, strips in their order",
          "[scheduler]") {
  const planner::Route route = comb(4, 6);
  const std::vector<Station> stations = two_stations();
  const RouteLengths lengths = route_lengths(route, stations);
  // The first aircraft begins with the last strip and ends with the beginning of the first.
  const SortieLists lists{{{.cells = {18, 6}, .station = 1}, {.cells = {0, 4}, .station = 0}},
                          {{.cells = {4, 8}, .station = 0}, {.cells = {12, 6}, .station = 1}}};
  const auto flown = flown_lists(route, lengths, small_fleet(2), stations, lists);
  REQUIRE(flown);
  REQUIRE(flown->uavs.size() == 2);
  const UavPlan& first = flown->uavs[0];
  CHECK(first.cells == CellRange{0, 10});
  CHECK(first.strips == CellRange{0, 2});
  CHECK(first.solution.plan.returns == planner::Returns{5});
  REQUIRE(first.landings.size() == 2);
  CHECK(first.landings[0].id == StationId{2});
  CHECK(first.landings[1].id == StationId{1});
  CHECK(flown->order.route.centers[0] == route.centers[18]);
  CHECK(flown->order.route.centers[6] == route.centers[0]);
  CHECK(flown->order.route.centers.size() == 24);
  // The second goes on in the strip that the first began, over the cell before, to the strip's end
  // and over the next one.
  const UavPlan& second = flown->uavs[1];
  CHECK(second.strips == CellRange{2, 3});
  CHECK(flown->order.route.strips[2].joins == route.centers[3]);
  CHECK_FALSE(flown->order.route.strips[3].joins);
  const auto sorties = orders(flown->order.route, second);
  CHECK(sorties[0].pieces[0].entry == route.centers[3]);
  CHECK(sorties[0].pieces[0].from == route.centers[4]);

  // Its second way out leads from where the first sortie ended: 16 m off, to (1, 1), at 6 m/s.
  CHECK(first.solution.plan.sorties[1].fly_out_s == Approx(std::sqrt(15.0 * 15 + 1) / 6));
  // And its first way home from (7, 1), where the last strip ends, to (16, 0).
  CHECK(first.solution.plan.sorties[0].fly_back_s == Approx(std::sqrt(9.0 * 9 + 1) / 6));
  CHECK(first.visits.size() == 1);
  CHECK(flown->forecast.makespan_s == std::max(first.spray_ends_s, second.spray_ends_s));
}

TEST_CASE("joint plan: what a tank does not carry is no plan", "[scheduler]") {
  const planner::Route route = comb(4, 6);
  const std::vector<Station> stations = two_stations();
  const SortieLists lists{{{.cells = {0, 24}, .station = 0}}};
  CHECK_FALSE(flown_lists(route, route_lengths(route, stations), small_fleet(1), stations, lists));
}

TEST_CASE("joint plan: no slower than till empty, simple, and what it begins with", "[scheduler]") {
  const planner::Route route = comb(12, 20);  // 480 m, 20 tanks
  const std::vector<Station> stations = two_stations();
  const RouteLengths lengths = route_lengths(route, stations);
  const auto fleet = small_fleet(3);
  SortieLists start(3);
  for (std::uint32_t n = 0; n < 24; ++n)
    start[n / 8].push_back({.cells = {10 * n, 10}, .station = n / 12});
  const auto begun = flown_lists(route, lengths, fleet, stations, start);
  REQUIRE(begun);
  for (const auto returns : {planner::ReturnStrategy::joint, planner::ReturnStrategy::gsa}) {
    const auto plan = joint_plan(route, lengths, fleet, stations, settings(returns), start);
    REQUIRE(plan);
    const double makespan_s = plan->flown.forecast.makespan_s;
    REQUIRE(plan->till_empty_s);
    CHECK(makespan_s <= *plan->till_empty_s);
    if (plan->simple_s) CHECK(makespan_s <= *plan->simple_s);
    if (returns == planner::ReturnStrategy::joint) {
      CHECK(makespan_s < begun->forecast.makespan_s);
    }
    CHECK(makespan_s >= fleet_bound(route, fleet, stations).makespan_s);
    std::uint32_t cells = 0;
    for (const UavPlan& uav : plan->flown.uavs) cells += uav.cells.count;
    CHECK(cells == 240);
    const auto again = joint_plan(route, lengths, fleet, stations, settings(returns), start);
    REQUIRE(again);
    CHECK(again->flown.forecast.makespan_s == makespan_s);
  }
}

TEST_CASE("joint plan: the same for one thread, two, and more than there are searches",
          "[scheduler]") {
  const planner::Route route = comb(12, 20);  // 480 m, 20 tanks
  const std::vector<Station> stations = two_stations();
  const RouteLengths lengths = route_lengths(route, stations);
  const auto fleet = small_fleet(3);
  const auto found = [&](std::size_t threads) {
    auto plan = joint_plan(route, lengths, fleet, stations,
                           settings(planner::ReturnStrategy::joint), {}, {}, {}, threads);
    REQUIRE(plan);
    return *plan;
  };
  const JointPlan one = found(1);
  REQUIRE(one.evaluations > 0);
  for (const std::size_t threads : {2, 3, 64, 0}) {
    const JointPlan other = found(threads);
    CHECK(other.evaluations == one.evaluations);
    CHECK(other.till_empty_s == one.till_empty_s);
    CHECK(other.simple_s == one.simple_s);
    CHECK(other.flown.forecast.makespan_s == one.flown.forecast.makespan_s);
    CHECK(other.flown.order.cells == one.flown.order.cells);
    for (std::size_t u = 0; u < fleet.size(); ++u) {
      const UavPlan &a = one.flown.uavs[u], &b = other.flown.uavs[u];
      CHECK(a.cells == b.cells);
      CHECK(a.solution.plan.returns == b.solution.plan.returns);
      CHECK(a.lands_s == b.lands_s);
      REQUIRE(a.landings.size() == b.landings.size());
      for (std::size_t k = 0; k < a.landings.size(); ++k) {
        CHECK(a.landings[k].id == b.landings[k].id);
      }
    }
  }
}

TEST_CASE("at once: answers come in order, and no more threads run than are wanted",
          "[scheduler]") {
  for (const std::size_t threads : {1, 2, 5}) {
    std::atomic<std::size_t> running = 0, most = 0;
    const auto square = [&](std::size_t i) {
      std::size_t now = ++running, seen = most;
      while (now > seen && !most.compare_exchange_weak(seen, now)) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds{2});
      --running;
      return i * i;
    };
    CHECK(planner::at_once(5, square, threads) == std::vector<std::size_t>{0, 1, 4, 9, 16});
    CHECK(most <= threads);
  }
}

TEST_CASE("fleet bound: one aircraft that sprays one strip ends no earlier than it can fly",
          "[scheduler]") {
  // A strip of 38 m along x = 1 from y = 1 to 39, the station at (0, 0), 3 m/s at work and 6 m/s on
  // ferries: sqrt(2) / 6 s out and 38 / 3 s of spraying. A tank lasts for 24 m, so there is one
  // return at least; filling has 20 s and 40 s of a tank for 14 m of 24.
  const planner::Route route = comb(1, 20);
  const std::vector<Station> one{station(1)};
  const auto fleet = small_fleet(1);
  const MakespanBound bound = fleet_bound(route, fleet, one);
  CHECK(bound.makespan_s >= std::sqrt(2.0) / 6 + 38.0 / 3 + 20);
  const auto till_empty = flown_lists(
      route, route_lengths(route, one), fleet, one,
      SortieLists{{{.cells = {0, 12}, .station = 0}, {.cells = {12, 8}, .station = 0}}});
  REQUIRE(till_empty);
  CHECK(bound.makespan_s <= till_empty->forecast.makespan_s);
}

TEST_CASE("fleet bound: corners that are cut with the valve open are given away", "[scheduler]") {
  // Two strips of 38 m and the step of 2 m between them, all at 1 m/s. Both corners are cut 1 m
  // before and behind, with an arc of pi / 2 m for 2 m, flown at sqrt(3 x 1) > 1 m/s: 78 - 2 (2 -
  // pi / 2) s. The way out, 1.4 m, is no longer than its corner.
  const planner::Route route = comb(2, 20);
  const std::vector<Station> one{station(1)};
  auto fleet = small_fleet(1);
  fleet[0].spray_speed = fleet[0].ferry_speed = metres_per_second(1);
  fleet[0].spray_endurance = seconds(100);
  const MakespanBound bound = fleet_bound(route, fleet, one);
  CHECK(bound.makespan_s <= 74.0 + std::numbers::pi);
  CHECK(bound.makespan_s > 76.5);
  const auto flown = flown_lists(route, route_lengths(route, one), fleet, one,
                                 SortieLists{{{.cells = {0, 40}, .station = 0}}});
  REQUIRE(flown);
  CHECK(bound.makespan_s <= flown->forecast.makespan_s);
}

}  // namespace
}  // namespace furrow::scheduler
