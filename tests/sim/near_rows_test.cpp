// Two aircraft on rows nearer to each other than aircraft keep, flown by all parts.
#include "agents/agent_node.hpp"
#include "planner/returns/evaluate.hpp"
#include "scheduler/scheduler_node.hpp"
#include "sim/checkers/laws.hpp"
#include "sim/simulate.hpp"
#include "supply/supply_node.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

namespace furrow::sim {
namespace {

constexpr Link radio{.latency = Duration{50'000'000}, .jitter = {}, .loss = 0, .duplication = 0};
constexpr Duration an_hour{3'600'000'000'000};
constexpr std::array flyers{AgentId{1}, AgentId{2}};

Vehicle vehicle(AgentId id) {
  return {.id = id,
          .home = at_m(0, 0),
          .swath = metres(4),
          .spray_speed = metres_per_second(3),
          .ferry_speed = metres_per_second(6),
          .spray_endurance = seconds(200),
          .flight_endurance = seconds(600),
          .battery_reserve = 0.1,
          .tank = litres(10),
          .min_turn_radius = metres(0),
          .acceleration_limit = metres_per_second2(3),
          .gnss = {}};
}

Station station() {
  return {.id = StationId{1},
          .position = at_m(0, 0),
          .bays = 1,
          .battery_swap = seconds(60),
          .fill_base = seconds(20),
          .fill_full = seconds(60)};
}

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
  for (const AgentId id : flyers) {
    const std::uint32_t cells = end(p.route.strips[1].cells);
    const CellRange share{id == flyers[0] ? 0 : cells, cells};
    scheduler::UavPlan uav{.vehicle = vehicle(id),
                           .station = station(),
                           .strips = {id == flyers[0] ? 0U : 2U, 2},
                           .cells = share,
                           .solution = {},
                           .visits = {},
                           .spray_ends_s = 0,
                           .lands_s = 0};
    const auto problem = planner::return_problem(p.route, share, uav.vehicle, station());
    uav.solution.plan = planner::evaluated(problem, {});
    p.uavs.push_back(std::move(uav));
  }
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

Log flown() {
  NodeHost host{radio, 1};
  host.add(scheduler_node(),
           AnyNode{scheduler::SchedulerNode{{.plan = plan(),
                                             .epoch = Epoch{1},
                                             .agent_lease = Duration{5'000'000'000},
                                             .mission_limit = an_hour,
                                             .separation = metres(1)}}},
           Instant{});
  host.add(
      node(StationId{1}),
      AnyNode{supply::SupplyNode{
          {.station = station(), .tanks = {{flyers[0], litres(10)}, {flyers[1], litres(10)}}}}},
      Instant{});
  for (const AgentId id : flyers) {
    host.add(node(id),
             AnyNode{agents::AgentNode{
                 {.vehicle = vehicle(id),
                  .stations = {station()},
                  .wind = {},
                  .airspace = agents::AirspaceRule{.layer = number(id) * metres(1.5)},
                  .seed = 1,
                  .boot = BootId{number(id)}}}},
             Instant{});
  }
  return simulate(host, radio.latency, Instant{an_hour});
}

TEST_CASE("near rows: one aircraft at a time is at work on rows nearer than the separation",
          "[sim]") {
  const Log log = flown();
  REQUIRE(log.finished);
  for (const Violation& v : violations(facts(), log.envelopes, log.ended)) {
    FAIL_CHECK(v.law << ": " << v.detail);
  }
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

}  // namespace
}  // namespace furrow::sim
