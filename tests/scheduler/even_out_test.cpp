#include "scheduler/even_out.hpp"

#include "planner/fleet/queue_clock.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

// Two alike, of large tanks, at one station; the first has all cells but two.
SortieLists uneven() {
  return {{{.cells = {0, 22}, .station = 0}}, {{.cells = {22, 2}, .station = 0}}};
}

std::vector<Vehicle> two() { return {vehicle(1), vehicle(2)}; }

SortieLists evened(SortieLists lists, std::uint64_t most) {
  const planner::Route route = comb(4, 6);
  const std::vector<Station> stations{station(1, 2, at_m(0, 0))};
  return evened_out(route, route_lengths(route, stations), two(), stations, std::move(lists), {},
                    most);
}

double makespan_s(const SortieLists& lists) {
  const planner::Route route = comb(4, 6);
  const std::vector<Station> stations{station(1, 2, at_m(0, 0))};
  return flown_lists(route, route_lengths(route, stations), two(), stations, lists)
      ->forecast.makespan_s;
}

TEST_CASE("even out: two aircraft come to share what one had, and every cell stays with one",
          "[scheduler]") {
  const SortieLists lists = evened(uneven(), 100);
  REQUIRE(lists[0].size() == 1);
  REQUIRE(lists[1].size() == 1);
  CHECK(lists[0][0].cells.first == 0);
  CHECK(end(lists[0][0].cells) == lists[1][0].cells.first);
  CHECK(end(lists[1][0].cells) == 24);
  // No other cut between the two is done earlier.
  for (std::uint32_t first = 2; first <= 22; ++first) {
    const SortieLists other{{{.cells = {0, first}, .station = 0}},
                            {{.cells = {first, 24 - first}, .station = 0}}};
    CHECK(makespan_s(lists) <= makespan_s(other));
  }
}

TEST_CASE("even out: who has nothing to fly stays where it is", "[scheduler]") {
  const SortieLists lists = evened({{{.cells = {0, 24}, .station = 0}}, {}}, 100);
  CHECK(lists[0][0].cells == CellRange{0, 24});
  CHECK(lists[1].empty());
}

TEST_CASE("even out: without a move to try, nothing changes", "[scheduler]") {
  const SortieLists lists = evened(uneven(), 0);
  CHECK(lists[0][0].cells == CellRange{0, 22});
  CHECK(lists[1][0].cells == CellRange{22, 2});
}

TEST_CASE("joint plan: of a quick and a slow aircraft the search foresees both", "[scheduler]") {
  FlightLoss slow{.flight_s = 2, .hop_s = 0}, quick{.flight_s = 5, .hop_s = 3};
  const planner::Route route = comb(3, 5);
  const std::vector<Station> stations{station(1, 2, at_m(0, 0))};
  const auto known = search_model(route, two(), stations, {.losses = {slow, quick}});
  const auto ideal = search_model(route, two(), stations, {});
  REQUIRE(known);
  REQUIRE(ideal);
  // From the begin of the first strip to the end of the third there are two ways between strips.
  const auto lost_s = [&](std::uint32_t flier) {
    const planner::fleet::Sortie all{.from_m = 0, .to_m = 30, .flier = flier, .depot = 0};
    return planner::fleet::flight_s(*known, all, at_m(0, 0)) -
           planner::fleet::flight_s(*ideal, all, at_m(0, 0));
  };
  CHECK(lost_s(0) == Approx(2));
  CHECK(lost_s(1) == Approx(5 + 2 * 3));
}

}  // namespace
}  // namespace furrow::scheduler
