// Planning a fleet's mission: the field of Wang et al. 2017 with three aircraft, and twenty on
// about 100 ha, three on an orchard of 20 ha with 200 trees. Counters: makespan and its lower bound
// in seconds, gap in per cent. And what is left of a lost aircraft's share, taken over by the
// others.

#include "core/random.hpp"
#include "scheduler/draft.hpp"
#include "scheduler/forecast.hpp"
#include "scheduler/plan_fleet.hpp"
#include "scheduler/takeover.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>

namespace furrow::scheduler {
namespace {

Vehicle vehicle(std::uint32_t id) {
  return {.id = AgentId{id},
          .home = at_m(0, 0),
          .swath = metres(2),
          .spray_speed = metres_per_second(3),
          .ferry_speed = metres_per_second(6),
          .spray_endurance = seconds(900.0),
          .flight_endurance = seconds(1500.0),
          .battery_reserve = 0.0,
          .tank = litres(10),
          .min_turn_radius = metres(0),
          .acceleration_limit = metres_per_second2(3),
          .gnss = {}};
}

Station station(std::uint32_t id, std::uint32_t bays, FieldPoint position) {
  return {.id = StationId{id},
          .position = position,
          .bays = bays,
          .battery_swap = seconds(60.0),
          .fill_base = seconds(20.0),
          .fill_full = seconds(60.0)};
}

FleetProblem problem(Ring boundary, std::vector<Station> stations, std::uint32_t uavs,
                     double budget_s) {
  FleetProblem p{.field = {.boundary = std::move(boundary), .holes = {}, .obstacles = {}},
                 .coverage = {},
                 .work_direction_deg = 0.0,
                 .stations = std::move(stations),
                 .vehicles = {},
                 .solver = {.returns = planner::ReturnStrategy::gsa,
                            .refine = true,
                            .paper_counting = false,
                            .iterations = 300,
                            .masses = 50,
                            .budget_s = budget_s,
                            .seed = 1}};
  for (std::uint32_t i = 1; i <= uavs; ++i) {
    p.vehicles.push_back(vehicle(i));
    p.vehicles.back().home = p.stations[(i - 1) * p.stations.size() / uavs].position;
  }
  return p;
}

FleetProblem field_a(std::uint32_t uavs) {
  return problem({at_m(0, 0), at_m(100, 0), at_m(100, 700), at_m(40, 700), at_m(0, 660)},
                 {station(1, 1, at_m(0, 0))}, uavs, 1.0);
}

FleetProblem hundred_hectares() {
  return problem({at_m(0, 0), at_m(1000, 0), at_m(1000, 1000), at_m(0, 1000)},
                 {station(1, 2, at_m(250, 0)), station(2, 2, at_m(750, 0))}, 20, 4.0);
}

void plan(benchmark::State& state, const FleetProblem& p) {
  for (auto _ : state) {
    const auto planned = plan_fleet(p);
    if (!planned) {
      state.SkipWithError(planned.error().detail.c_str());
      return;
    }
    double wait_s = 0.0;
    for (const UavPlan& u : planned->uavs) {
      for (const Visit& v : u.visits) wait_s += v.starts_s - v.arrives_s;
    }
    state.counters["makespan_s"] = planned->makespan_s;
    state.counters["bound_s"] = planned->lower_bound_s;
    state.counters["gap_percent"] = 100.0 * (planned->makespan_s / planned->lower_bound_s - 1.0);
    state.counters["queue_wait_s"] = wait_s;
  }
}

void BM_plan_field_a(benchmark::State& state) {
  plan(state, field_a(static_cast<std::uint32_t>(state.range(0))));
}
BENCHMARK(BM_plan_field_a)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);

// 20 ha with `trees` round obstacles of 0.5 to 2 m, rows of 6 m led around them.
FleetProblem orchard(std::uint32_t trees) {
  FleetProblem p = problem({at_m(0, 0), at_m(400, 0), at_m(400, 500), at_m(0, 500)},
                           {station(1, 2, at_m(200, -10))}, 3, 10.0);
  planner::SwathSettings rows;
  rows.avoidance.emplace().safety = metres(1.5);
  rows.avoidance->turn_radius = metres(3);
  p.coverage = rows;
  for (Vehicle& v : p.vehicles) v.swath = metres(6);
  Random random{200};
  for (std::uint32_t i = 0; i < trees; ++i) {
    p.field.obstacles.push_back({"tree" + std::to_string(i),
                                 at_m(random.uniform(5, 395), random.uniform(5, 495)),
                                 metres(random.uniform(0.5, 2)),
                                 {}});
  }
  return p;
}

void BM_plan_orchard(benchmark::State& state) {
  plan(state, orchard(static_cast<std::uint32_t>(state.range(0))));
}
BENCHMARK(BM_plan_orchard)->Arg(0)->Arg(200)->Unit(benchmark::kMillisecond)->Iterations(1);

// Ten aircraft and one bay on the field of Wang et al.: what a larger budget of the joint search
// still finds. 10 is what scenarios have by default.
void BM_plan_by_budget(benchmark::State& state) {
  FleetProblem p = field_a(10);
  p.solver.returns = planner::ReturnStrategy::joint;
  p.solver.budget_s = static_cast<double>(state.range(0));
  plan(state, p);
}
BENCHMARK(BM_plan_by_budget)
    ->Arg(1)
    ->Arg(10)
    ->Arg(60)
    ->Arg(600)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->Iterations(1);

// Five hectares for each aircraft, a station of three bays for every twenty.
FleetProblem growing_fleet(std::uint32_t uavs) {
  constexpr double each_m2 = 50'000, deepest_m = 2500;
  const double deep_m = std::min(std::sqrt(each_m2 * uavs), deepest_m);
  const double wide_m = each_m2 * uavs / deep_m;
  const std::uint32_t count = std::max(uavs / 20, 1u);
  std::vector<Station> stations;
  for (std::uint32_t s = 0; s < count; ++s) {
    stations.push_back(station(s + 1, 3, at_m(wide_m * (s + 0.5) / count, -20)));
  }
  FleetProblem p = problem({at_m(0, 0), at_m(wide_m, 0), at_m(wide_m, deep_m), at_m(0, deep_m)},
                           stations, uavs, 10);
  p.solver.returns = planner::ReturnStrategy::joint;
  planner::SwathSettings rows;
  rows.direction_deg = 0.0;
  p.coverage = rows;
  for (Vehicle& v : p.vehicles) {
    v.swath = metres(8);
    v.spray_speed = metres_per_second(6);
    v.ferry_speed = metres_per_second(12);
    v.flight_endurance = seconds(1200.0);
    v.spray_endurance = seconds(277.8);  // 20 L at 15 L/ha
  }
  return p;
}

void BM_plan_growing_fleet(benchmark::State& state) {
  plan(state, growing_fleet(static_cast<std::uint32_t>(state.range(0))));
}
BENCHMARK(BM_plan_growing_fleet)
    ->RangeMultiplier(10)
    ->Range(1, 1000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->Iterations(1);

// The two hundred aircraft of scenarios/fleet_200.yaml by the budget of the search.
void BM_plan_two_hundred_by_budget(benchmark::State& state) {
  FleetProblem p = growing_fleet(200);
  p.solver.budget_s = static_cast<double>(state.range(0));
  plan(state, p);
}
BENCHMARK(BM_plan_two_hundred_by_budget)
    ->Arg(1)
    ->Arg(10)
    ->Arg(60)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->Iterations(1);

void BM_plan_hundred_hectares(benchmark::State& state) { plan(state, hundred_hectares()); }
BENCHMARK(BM_plan_hundred_hectares)->Unit(benchmark::kMillisecond)->Iterations(1);

void BM_draft_hundred_hectares(benchmark::State& state) {
  const FleetProblem p = hundred_hectares();
  const auto coverage = planner::cover(p.field, metres(2), p.coverage);
  const planner::Route* route = &coverage->route;
  const RouteLengths lengths = route_lengths(*route, p.stations);
  for (auto _ : state) {
    const Draft drafted = draft(*route, lengths, p.vehicles, p.stations);
    state.counters["makespan_s"] = drafted.forecast.makespan_s;
    state.counters["queue_wait_s"] = drafted.forecast.queue_wait_s;
  }
}
BENCHMARK(BM_draft_hundred_hectares)->Unit(benchmark::kMillisecond);

// One of twenty lost after a fifth of its share.
void BM_takeover_of_one_of_twenty(benchmark::State& state) {
  const FleetProblem p = hundred_hectares();
  const auto coverage = planner::cover(p.field, metres(2), p.coverage);
  const planner::Route* route = &coverage->route;
  const auto share = static_cast<std::uint32_t>(route->centers.size() / 20);
  const std::vector<CellRange> orphans{{share + share / 5, share - share / 5}};
  std::vector<Survivor> survivors;
  for (std::uint32_t i = 1; i < 20; ++i) {
    survivors.push_back(
        {.vehicle = p.vehicles[i], .station = p.stations[i % 2], .ready_s = 5000.0 + 10.0 * i});
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(take_over(*route, orphans, survivors).additions.size());
  }
}
BENCHMARK(BM_takeover_of_one_of_twenty)->Unit(benchmark::kMillisecond);

// All that twenty aircraft have not begun half way through a hundred hectares, in rows of 5 m.
void BM_new_plan_for_twenty(benchmark::State& state) {
  FleetProblem p = hundred_hectares();
  const auto coverage = planner::cover(p.field, metres(5), p.coverage);
  const planner::Route* route = &coverage->route;
  const auto cells = static_cast<std::uint32_t>(route->centers.size());
  const std::vector<CellRange> unbegun{{cells / 2, cells - cells / 2}};
  std::vector<Survivor> survivors;
  for (std::uint32_t i = 0; i < 20; ++i) {
    p.vehicles[i].swath = metres(5);
    survivors.push_back(
        {.vehicle = p.vehicles[i], .station = p.stations[i % 2], .ready_s = 5000.0 + 10.0 * i});
  }
  for (auto _ : state) {
    double latest_s = 0.0;
    for (const Addition& a : take_over(*route, unbegun, survivors).additions) {
      latest_s = std::max(latest_s, a.lands_s);
    }
    state.counters["makespan_s"] = latest_s;
  }
}
BENCHMARK(BM_new_plan_for_twenty)->Unit(benchmark::kMillisecond);

// Twenty aircraft, ten returns each, at two stations of two bays.
void BM_forecast(benchmark::State& state) {
  const std::vector stations{station(1, 2, at_m(0, 0)), station(2, 2, at_m(0, 0))};
  std::vector<Itinerary> fleet;
  for (std::uint32_t i = 0; i < 20; ++i) {
    fleet.push_back({.agent = AgentId{i + 1},
                     .flights_s = std::vector(10, 950.0 + 3.0 * i),
                     .services_s = std::vector(10, 60.0),
                     .stations = std::vector(10, i % 2),
                     .last_spray_s = 500,
                     .last_home_s = 50,
                     .flies = true});
  }
  for (auto _ : state) benchmark::DoNotOptimize(forecast(fleet, stations).makespan_s);
}
BENCHMARK(BM_forecast)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace furrow::scheduler
