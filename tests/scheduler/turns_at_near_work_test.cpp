#include "scheduler/turns_at_near_work.hpp"

#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

namespace furrow::scheduler {
namespace {

/// Four rows of 20 cells; the last is half a metre from the third.
planner::Route rows() {
  std::vector<planner::Strip> strips;
  for (const double x_m : {1.0, 3.0, 5.0, 5.5}) {
    strips.push_back(planner::end_strip({0, 1}, at_m(x_m, 0), at_m(x_m, 40), {}));
  }
  return planner::end_to_end_route(metres(2), std::move(strips));
}

const std::vector<Vehicle> fleet{vehicle(1), vehicle(2)};
/// Where filling takes so long that first flights are far from second ones in time.
const std::vector<Station> two_bays = [] {
  Station at = station(1, 2);
  at.fill_base = seconds(90);
  at.fill_full = seconds(120);
  return std::vector<Station>{at};
}();

FlownLists flown(const SortieLists& lists) {
  const planner::Route route = rows();
  auto found = flown_lists(route, route_lengths(route, two_bays), fleet, two_bays, lists);
  REQUIRE(found);
  return *found;
}

TEST_CASE("turns at near work: two who spray near rows at the same time will wait", "[scheduler]") {
  // Each has a row of its own first, then one of the near ones, which take 13 s and the ways there
  // and back: both are there at the same time, unsure by 15 s before and after.
  const SortieLists both_last{{{{0, 20}, 0}, {{40, 20}, 0}}, {{{20, 20}, 0}, {{60, 20}, 0}}};
  const double waits_s = waits_at_near_work_s(flown(both_last), rows(), metres(1));
  CHECK(waits_s > 13 + 2 * 15);
  CHECK(waits_s < 90);
  CHECK(waits_at_near_work_s(flown(both_last), rows(), metres(0.4)) == 0.0);
  const SortieLists one_by_one{{{{40, 20}, 0}, {{0, 20}, 0}}, {{{20, 20}, 0}, {{60, 20}, 0}}};
  CHECK(waits_at_near_work_s(flown(one_by_one), rows(), metres(1)) == 0.0);
  // Parts of one row are near at their ends only.
  const SortieLists parts{{{{0, 10}, 0}, {{40, 40}, 0}}, {{{10, 10}, 0}, {{20, 20}, 0}}};
  CHECK(waits_at_near_work_s(flown(parts), rows(), metres(1)) == 0.0);
}

TEST_CASE("turns at near work: flights change their place in the list where that saves waits",
          "[scheduler]") {
  const planner::Route route = rows();
  const SortieLists both_last{{{{0, 20}, 0}, {{40, 20}, 0}}, {{{20, 20}, 0}, {{60, 20}, 0}}};
  const FlownLists before = flown(both_last);
  const FlownLists after = turned_at_near_work(before, route, route_lengths(route, two_bays), fleet,
                                               two_bays, metres(1));
  CHECK(waits_at_near_work_s(after, route, metres(1)) == 0.0);
  CHECK(after.forecast.makespan_s < before.forecast.makespan_s + 5);
  std::vector<std::uint32_t> cells = after.order.cells;
  CHECK_FALSE(std::is_sorted(cells.begin(), cells.end()));
  std::sort(cells.begin(), cells.end());
  CHECK(cells.size() == route.centers.size());
  CHECK(std::adjacent_find(cells.begin(), cells.end()) == cells.end());
  // Where nobody waits nothing is changed.
  const FlownLists same = turned_at_near_work(before, route, route_lengths(route, two_bays), fleet,
                                              two_bays, metres(0.4));
  CHECK(same.order.cells == before.order.cells);
}

}  // namespace
}  // namespace furrow::scheduler
