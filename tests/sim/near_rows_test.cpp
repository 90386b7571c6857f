// Two aircraft on rows nearer to each other than aircraft keep, flown by all parts.
#include "tests/sim/check_laws.hpp"
#include "tests/sim/one_station.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

namespace furrow::sim {
namespace {

constexpr std::array flyers{AgentId{1}, AgentId{2}};

// Each has a row at the edge, then one in the middle, all of 100 m and flown away from y = 10 and
// back: they would come to the middle at the same time, 0.7 m apart.
planner::Route route() {
  return planner::end_to_end_route(
      metres(4), {planner::end_strip({0, 1}, at_m(6, 10), at_m(6, 110), {}),
                  planner::end_strip({0, 1}, at_m(10, 110), at_m(10, 10), {}),
                  planner::end_strip({0, 1}, at_m(14.7, 10), at_m(14.7, 110), {}),
                  planner::end_strip({0, 1}, at_m(10.7, 110), at_m(10.7, 10), {})});
}

scheduler::FleetPlan plan() {
  scheduler::FleetPlan p{
      .route = route(), .work_direction_deg = 0, .uavs = {}, .makespan_s = 0, .lower_bound_s = 0};
  p.uavs = {uav_plan(p.route, vehicle(flyers[0]), {0, 2}, {}),
            uav_plan(p.route, vehicle(flyers[1]), {2, 2}, {})};
  return p;
}

Facts facts() {
  return {.field = {.boundary = {at_m(4, 10), at_m(16.7, 10), at_m(16.7, 110), at_m(4, 110)},
                    .holes = {},
                    .obstacles = {}},
          .stations = {station()},
          .plan = plan(),
          .claim_lease = Duration{3'000'000'000},
          .whole = true,
          .separation = metres(1)};
}

TEST_CASE("near rows: one aircraft at a time is at work on rows nearer than the separation",
          "[sim]") {
  const Log log = flown(plan(), metres(1));
  REQUIRE(log.finished);
  check_laws(facts(), log);
  SchedulerState last{};
  std::vector<std::string> waits;
  for (const Envelope& e : log.envelopes) {
    if (const auto* state = std::get_if<SchedulerState>(&e.body)) last = *state;
    const auto* event = std::get_if<Event>(&e.body);
    if (event != nullptr && event->kind == "hold_begun") waits.push_back(event->detail);
  }
  CHECK(last.completed);
  CHECK(last.sprayed_cells == route().centers.size());
  // Who takes off second comes second: 25 cells of 4 m a row, its second row is the last.
  CHECK(waits == std::vector<std::string>{"agent 2 waits in the air for a grant of cell 75"});
  // 33 s a row: three rows one after another and what turns and ways take.
  CHECK(seconds(log.ended).base() > 100);
  CHECK(seconds(log.ended).base() < 160);
}

// Each has every other row of 4 m, all flown away from the station and back: both hop past the end
// of a row of the other. The first row of the second begins at y_m.
planner::Route combed(double y_m) {
  return planner::end_to_end_route(metres(4),
                                   {planner::end_strip({0, 1}, at_m(6, 10), at_m(6, 110), {}),
                                    planner::end_strip({0, 1}, at_m(14, 110), at_m(14, 10), {}),
                                    planner::end_strip({0, 1}, at_m(10, y_m), at_m(10, 110), {}),
                                    planner::end_strip({0, 1}, at_m(18, 110), at_m(18, 10), {})});
}

TEST_CASE("near rows: nobody hops past the end of a row while another is there", "[sim]") {
  // Flown low and unasked the hops met within 0.3 m: the second comes to (10, 110) as the first
  // passes.
  for (const double y_m : {10.0, 11.5, 13.0, 14.5}) {
    Facts f = facts();
    f.field.boundary = {at_m(4, 10), at_m(20, 10), at_m(20, 110), at_m(4, 110)};
    f.plan.route = combed(y_m);
    f.plan.uavs = {uav_plan(f.plan.route, vehicle(flyers[0]), {0, 2}, {}),
                   uav_plan(f.plan.route, vehicle(flyers[1]), {2, 2}, {})};
    const Log log = flown(f.plan, f.separation);
    REQUIRE(log.finished);
    check_laws(f, log);
  }
}

}  // namespace
}  // namespace furrow::sim
