#include "app/results/ways.hpp"

#include "tests/app/results/small_mission.hpp"

#include <catch2/catch.hpp>

namespace furrow::app {
namespace {

TEST_CASE("ways: a strip that goes on from the cell before is entered at its own first cell") {
  MissionRecord record = small_plan();
  // The second strip flown northwards too: from (1, 7) askew to (3, 1), where UAV 1 returns.
  planner::Route& route = record.plan.route;
  route.strips[1] = planner::centre_strip({4, 4}, at_m(3, 1), at_m(3, 7), true);
  for (int i = 0; i < 4; ++i) route.centers[4 + static_cast<std::size_t>(i)] = at_m(3, 1 + 2 * i);

  const Way first = planned_ways(route, record.plan.uavs[0]).at_work.at(0);
  CHECK(length_m({first}) == Approx(6 + std::sqrt(2 * 2 + 6 * 6)));
}

}  // namespace
}  // namespace furrow::app
