#pragma once
// A mission small enough to work out by hand, shared by the tests of the results.

#include "app/results/mission_record.hpp"

namespace furrow::app {

/// A field of 6 m x 8 m, three strips of four 2 m cells along north, and two UAVs: UAV 1 flies
/// strips 1 and 2 in two sorties with a return after its fifth cell, UAV 2 flies strip 3 in one.
///
///     y=7   3  4 11        Station 1 with one bay stands at (0, 0), the swath is 2 m,
///     y=5   2  5 10        spray speed 1 m/s, ferry speed 2 m/s, a tank lasts for 10 s.
///     y=3   1  6  9        UAV 1 starts at cell 0 and UAV 2 at cell 8, so no way out.
///     y=1   0  7  8        Cell numbers of the route are shown.
///          x=1 x=3 x=5
inline MissionRecord small_plan() {
  MissionRecord record{};
  mission::Scenario& s = record.scenario;
  s.name = "small";
  s.seed = 7;
  s.field.boundary = {at_m(0, 0), at_m(6, 0), at_m(6, 8), at_m(0, 8)};
  s.stations = {{.id = StationId{1},
                 .position = at_m(0, 0),
                 .bays = 1,
                 .battery_swap = seconds(60.0),
                 .fill_base = seconds(20.0),
                 .fill_full = seconds(60.0)}};
  s.solver.returns = planner::ReturnStrategy::exact;
  s.link.latency = Duration{50'000'000};

  planner::Route& route = record.plan.route;
  route.cell = metres(2);
  for (const double y : {1, 3, 5, 7}) route.centers.push_back(at_m(1, y));
  for (const double y : {7, 5, 3, 1}) route.centers.push_back(at_m(3, y));
  for (const double y : {1, 3, 5, 7}) route.centers.push_back(at_m(5, y));
  route.strips = {planner::centre_strip({0, 4}, at_m(1, 1), at_m(1, 7), false),
                  planner::centre_strip({4, 4}, at_m(3, 7), at_m(3, 1), true),
                  planner::centre_strip({8, 4}, at_m(5, 1), at_m(5, 7), true)};

  for (const std::uint32_t id : {1u, 2u}) {
    Vehicle v{};
    v.id = AgentId{id};
    v.home = id == 1 ? at_m(1, 1) : at_m(5, 1);
    v.swath = metres(2);
    v.spray_speed = metres_per_second(1);
    v.ferry_speed = metres_per_second(2);
    v.spray_endurance = seconds(10.0);
    v.flight_endurance = seconds(100.0);
    v.tank = litres(5);
    s.uavs.push_back(v);
  }

  // UAV 1 returns at cell 4, (3, 7): 5 moves of 2 m less one = 8 m; home is sqrt(58) = 7.615773 m.
  // It sprays the other 6 m after a swap (60 s), and a fill of 0.6 tank (20 + 0.6 * 40 = 44 s).
  scheduler::UavPlan first{};
  first.vehicle = s.uavs[0];
  first.station = s.stations[0];
  first.strips = {0, 2};
  first.cells = {0, 8};
  const double home_s = 7.615773105863909 / 2, end_home_s = 3.1622776601683795 / 2;
  first.solution.plan.returns = {4};
  first.solution.plan.sorties = {{.first = 0,
                                  .last = 4,
                                  .spray_m = 8,
                                  .fly_out_s = 0,
                                  .spray_s = 8,
                                  .fly_back_s = home_s,
                                  .pack = 1,
                                  .battery_used = 0.118,
                                  .battery_swap_s = 60,
                                  .fill_s = 44,
                                  .service_s = 60},
                                 {.first = 4,
                                  .last = 7,
                                  .spray_m = 6,
                                  .fly_out_s = home_s,
                                  .spray_s = 6,
                                  .fly_back_s = end_home_s,
                                  .pack = 2,
                                  .battery_used = 0.114,
                                  .battery_swap_s = 0,
                                  .fill_s = 0,
                                  .service_s = 0}};
  first.solution.plan.non_spray_s = 60 + 2 * home_s;  // 67.615773
  first.solution.plan.round_trips_m = 4 * home_s;
  first.solution.plan.swaps = 1;
  first.solution.lower_bound_s = first.solution.plan.non_spray_s;
  first.solution.proven = true;
  first.solution.evaluations = 12;
  first.visits = {
      {.arrives_s = 8 + home_s, .starts_s = 8 + home_s, .ready_s = 68 + home_s, .bay = 1}};
  first.spray_ends_s = 74 + 2 * home_s;
  first.lands_s = first.spray_ends_s + end_home_s;

  scheduler::UavPlan second{};
  second.vehicle = s.uavs[1];
  second.station = s.stations[0];
  second.strips = {2, 1};
  second.cells = {8, 4};
  second.solution.plan.sorties = {{.first = 0,
                                   .last = 3,
                                   .spray_m = 6,
                                   .fly_out_s = 0,
                                   .spray_s = 6,
                                   .fly_back_s = 4.301162633521313,  // sqrt(74) / 2
                                   .pack = 1,
                                   .battery_used = 0.103,
                                   .battery_swap_s = 0,
                                   .fill_s = 0,
                                   .service_s = 0}};
  second.solution.proven = true;
  second.spray_ends_s = 6;
  second.lands_s = 10.301162633521313;

  record.plan.uavs = {first, second};
  record.plan.makespan_s = first.spray_ends_s;  // 81.615773
  record.plan.lower_bound_s = 80;
  record.mode = Mode::plan;
  record.timing = {.plan_wall_s = 0.5, .run_wall_s = 0, .solver_wall_s = 0.25};
  return record;
}

/// The same mission flown by both, with UAV 2 passing its cells 0.5 m to the right (east), and its
/// last cell without a closed grant.
inline MissionRecord small_flight() {
  MissionRecord record = small_plan();
  record.mode = Mode::sim;
  record.timing.run_wall_s = 2;
  const auto at = [](double t_s) { return instant(seconds(t_s)); };
  std::uint64_t seq[3] = {};
  const auto say = [&](NodeId from, double t_s, Body body) {
    record.log.push_back({from, ++seq[from.number], at(t_s), std::move(body)});
  };
  const NodeId one = node(AgentId{1}), two = node(AgentId{2});

  const WorkReport strip_three{
      AgentId{2},
      {},
      Epoch{1},
      {{.grant = 1, .cells = {8, 4}, .sprayed = 3, .reason = CloseReason::tank_low, .at = at(6)}}};
  FlightRecord two_flew{};
  two_flew.agent = AgentId{2};
  two_flew.cells = {8, 4};
  two_flew.offsets_m = {0.5f, 0.5f, 0.5f, 0.5f};
  two_flew.truth = {.samples = 4, .sum_squares = 1.0, .largest = 0.5};
  two_flew.fix = {.samples = 4, .sum_squares = 0.04, .largest = 0.1};
  two_flew.track = {{at(0), at_m(5.5, 1), true}, {at(6), at_m(5.5, 7), false}};
  say(two, 6, strip_three);
  say(two, 7, strip_three);  // repeated until it is booked; counts once
  say(two, 7, two_flew);

  FlightRecord one_flew{};
  one_flew.agent = AgentId{1};
  one_flew.cells = {0, 5};
  one_flew.offsets_m = {0, 0, 0, 0, 0};
  one_flew.truth = {.samples = 5, .sum_squares = 0, .largest = 0};
  one_flew.fix = one_flew.truth;
  one_flew.track = {
      {at(0), at_m(1, 1), true}, {at(8), at_m(3, 7), false}, {at(12), at_m(0, 0), false}};
  say(one, 8, one_flew);
  say(one, 9,
      WorkReport{AgentId{1},
                 {},
                 Epoch{1},
                 {{.grant = 1,
                   .cells = {0, 5},
                   .sprayed = 5,
                   .reason = CloseReason::sprayed,
                   .at = at(8)}}});
  SortieReport sortie{};
  sortie.agent = AgentId{1};
  sortie.resumed_at = at_m(1, 1);
  sortie.returned_at = at_m(3, 7);
  sortie.sprayed = metres(8);
  sortie.ferried = metres(8);
  sortie.flight = seconds(12.0);
  sortie.pack = 1;
  sortie.battery_used = 0.12;
  sortie.spray_ended = at(8);
  sortie.landed = at(12);
  sortie.serviced = true;
  sortie.station = StationId{1};
  sortie.bay = 1;
  sortie.swapped = true;
  sortie.filled = 0.6;
  sortie.wait = seconds(3.0);
  sortie.swap_time = seconds(60.0);
  sortie.fill_time = seconds(44.0);
  say(one, 75, sortie);

  one_flew.cells = {5, 3};
  one_flew.offsets_m = {0, 0, 0};
  one_flew.truth.samples = one_flew.fix.samples = 3;
  one_flew.track = {{at(75), at_m(0, 0), false},
                    {at(79), at_m(3, 7), true},
                    {at(85), at_m(3, 1), false},
                    {at(87), at_m(0, 0), false}};
  say(one, 85, one_flew);
  say(one, 85,
      WorkReport{AgentId{1},
                 {},
                 Epoch{1},
                 {{.grant = 2,
                   .cells = {5, 3},
                   .sprayed = 3,
                   .reason = CloseReason::sprayed,
                   .at = at(85)}}});
  sortie.sortie = 1;
  sortie.resumed_at = at_m(3, 7);
  sortie.returned_at = at_m(3, 1);
  sortie.sprayed = metres(6);
  sortie.ferried = metres(6);
  sortie.flight = seconds(12.0);
  sortie.pack = 2;
  sortie.battery_used = 0.12;
  sortie.began = at(75);
  sortie.spray_ended = at(85);
  sortie.landed = at(87);
  sortie.serviced = false;
  say(one, 87, sortie);

  SchedulerState last{};
  last.phase = MissionPhase::finished;
  last.completed = false;
  last.sprayed_cells = 11;
  last.abandoned_cells = 1;
  say(scheduler_node(), 88, last);
  return record;
}

}  // namespace furrow::app
