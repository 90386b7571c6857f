#include "scheduler/plan_fleet.hpp"

#include "core/random.hpp"
#include "planner/coverage/swath/swath.hpp"
#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"
#include "scheduler/forecast.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

#include <functional>

namespace furrow::scheduler {
namespace {

using planner::PlanFault;
using planner::ReturnStrategy;

// The makespan when each aircraft of `plan` flies its share as `planned` says.
template <class Planned>
double makespan_s(const FleetPlan& plan, const std::vector<Station>& stations, Planned planned) {
  std::vector<Itinerary> fleet;
  for (const UavPlan& u : plan.uavs) {
    const auto p = planner::return_problem(plan.route, u.cells, u.vehicle, u.station);
    fleet.push_back(
        itinerary(u.vehicle.id, number(u.station.id) - 1, *planned(p), FlightTimes{plan.route, p}));
  }
  return forecast(fleet, stations).makespan_s;
}

TEST_CASE("plan_fleet: one aircraft alone gets what the planner finds for it", "[scheduler]") {
  const FleetProblem p = problem(60, 400, 1);
  const auto plan = plan_fleet(p);
  REQUIRE(plan);
  const UavPlan& uav = plan->uavs[0];
  const auto alone = planner::solve(
      planner::return_problem(plan->route, uav.cells, p.vehicles[0], p.stations[0]), p.solver);
  REQUIRE(alone);
  CHECK(uav.solution.plan.returns == alone->plan.returns);
  CHECK(uav.cells.count == plan->route.centers.size());
  // Spraying, the way out and what is not spraying; nobody to wait for. Corners and ramps add up
  // to a few seconds for each of the 30 strips and returns.
  const double spray_m = 2.0 * (static_cast<double>(plan->route.centers.size()) - 1);
  const double constant_s = std::sqrt(2.0) / 6 + spray_m / 3 + alone->plan.non_spray_s;
  CHECK(plan->makespan_s > constant_s);
  CHECK(plan->makespan_s < constant_s + 100);
  CHECK(plan->lower_bound_s <= constant_s);
}

TEST_CASE("plan_fleet: every strip is somebody's, forecasts agree, and the bound holds",
          "[scheduler]") {
  const FleetProblem p = problem(100, 400, 3);
  const auto plan = plan_fleet(p);
  REQUIRE(plan);
  std::uint32_t next = 0;
  for (const UavPlan& u : plan->uavs) {
    CHECK(u.strips.first == next);
    next = end(u.strips);
    CHECK(u.visits.size() == u.solution.plan.returns.size());
    CHECK(u.spray_ends_s <= plan->makespan_s);
    CHECK(u.lands_s > u.spray_ends_s);
  }
  CHECK(next == plan->route.strips.size());
  CHECK(plan->lower_bound_s > 0);
  CHECK(plan->lower_bound_s <= plan->makespan_s);
}

TEST_CASE("plan_fleet: who joins late has no share, and counts for the bound", "[scheduler]") {
  FleetProblem p = problem(100, 400, 3);
  p.joining = {p.vehicles[1]};
  p.vehicles.erase(p.vehicles.begin() + 1);
  const auto plan = plan_fleet(p);
  const auto of_two = plan_fleet({.field = p.field,
                                  .coverage = p.coverage,
                                  .work_direction_deg = p.work_direction_deg,
                                  .stations = p.stations,
                                  .vehicles = p.vehicles,
                                  .solver = p.solver});
  REQUIRE(plan);
  REQUIRE(of_two);
  REQUIRE(plan->uavs.size() == 3);
  for (std::size_t u = 0; u < 3; ++u) {
    CHECK(plan->uavs[u].vehicle.id == AgentId{static_cast<std::uint32_t>(u + 1)});
    CHECK(plan->uavs[u].joins_late == (u == 1));
    CHECK((plan->uavs[u].strips.count == 0) == (u == 1));
  }
  CHECK(plan->makespan_s == of_two->makespan_s);
  CHECK(plan->lower_bound_s < of_two->lower_bound_s);  // three from the start might do better
}

TEST_CASE("plan_fleet: no worse than all aircraft unplanned, and than all simple", "[scheduler]") {
  const FleetProblem p = problem(100, 400, 4);
  const auto plan = plan_fleet(p);
  REQUIRE(plan);
  CHECK(plan->makespan_s <= makespan_s(*plan, p.stations, [](const auto& share) {
                              return planner::unplanned_plan(share);
                            }) + 1e-9);
  CHECK(plan->makespan_s <= makespan_s(*plan, p.stations, [](const auto& share) {
                              return planner::simple_plan(share);
                            }) + 1e-9);
}

TEST_CASE("plan_fleet: sorties chosen jointly are no slower than what they were chosen from",
          "[scheduler]") {
  Random random{1};
  for (int n = 0; n < 12; ++n) {
    CAPTURE(n);
    const auto uavs = static_cast<std::uint32_t>(2 + random.below(3));
    FleetProblem p = problem(random.uniform(20, 60), random.uniform(60, 200), uavs);
    p.stations.push_back(station(2, 1, at_m(random.uniform(0, 60), -10)));
    for (Vehicle& v : p.vehicles) v.spray_endurance = seconds(random.uniform(60, 200));
    p.solver.returns = n % 3 == 0 ? ReturnStrategy::gsa : ReturnStrategy::joint;
    p.solver.budget_s = 0.2;
    const auto plan = plan_fleet(p);
    REQUIRE(plan);
    REQUIRE(plan->yardsticks);
    CHECK(plan->makespan_s <= plan->yardsticks->shares_s);
    CHECK(plan->makespan_s <= plan->yardsticks->till_empty_s.value_or(1e9));
    CHECK(plan->makespan_s <= plan->yardsticks->simple_s.value_or(1e9));
    CHECK(plan->lower_bound_s > 0);
    CHECK(plan->lower_bound_s <= plan->makespan_s);
    CHECK_FALSE(plan->bound.empty());
    std::uint32_t next = 0;
    for (const UavPlan& u : plan->uavs) {
      CHECK(u.cells.first == next);
      next = end(u.cells);
      CHECK((u.landings.empty() || u.landings.size() == u.visits.size() + 1));
    }
    CHECK(next == plan->route.centers.size());
  }
}

TEST_CASE("plan_fleet: ferries of a walk lead around what lies between its cells", "[scheduler]") {
  FleetProblem p = problem(60, 60, 1);
  p.field.holes = {{at_m(20, 12), at_m(40, 12), at_m(40, 60), at_m(20, 60)}};
  p.work_direction_deg = 90;
  const auto plan = plan_fleet(p);
  REQUIRE(plan);
  std::size_t led = 0;
  const auto& strips = plan->route.strips;
  for (std::size_t i = 1; i < strips.size(); ++i) {
    if (strips[i].continues) continue;
    std::vector<FieldPoint> way{strips[i - 1].end};
    way.insert(way.end(), strips[i].approach.begin(), strips[i].approach.end());
    way.push_back(strips[i].begin);
    INFO("from strip " << i);
    const auto outside = planner::length_outside(p.field, {way}, metres(0.1));
    REQUIRE(outside);
    CHECK(*outside == Length{});
    if (!strips[i].approach.empty()) ++led;
  }
  CHECK(led > 0);
}

TEST_CASE("plan_fleet: ways between parts of a split field lead around obstacles", "[scheduler]") {
  FleetProblem p = problem(300, 100, 1);
  // Two squares joined by a neck of 10 m, too narrow for a margin of 6 m; between their tops, over
  // foreign land, a pylon.
  p.field.boundary = {at_m(0, 0),    at_m(100, 0),  at_m(100, 45),  at_m(200, 45),
                      at_m(200, 0),  at_m(300, 0),  at_m(300, 100), at_m(200, 100),
                      at_m(200, 55), at_m(100, 55), at_m(100, 100), at_m(0, 100)};
  p.field.obstacles = {{"pylon", at_m(150, 94), metres(5)}};
  p.coverage = planner::SwathSettings{.margin = metres(6)};
  p.work_direction_deg.reset();
  const auto plan = plan_fleet(p);
  REQUIRE(plan);
  REQUIRE(plan->sweep->parts == 2);
  int between_parts = 0;
  for (std::size_t i = 1; i < plan->route.strips.size(); ++i) {
    const planner::Strip& before = plan->route.strips[i - 1];
    const planner::Strip& strip = plan->route.strips[i];
    std::vector<FieldPoint> way{before.end};
    way.insert(way.end(), strip.approach.begin(), strip.approach.end());
    way.push_back(strip.begin);
    between_parts += before.end.x < metres(150) && strip.begin.x > metres(150);
    const auto outside = planner::length_outside(p.field, {way}, metres(0.01));
    REQUIRE(outside);
    CHECK(*outside == Length{});
    for (std::size_t k = 1; k < way.size(); ++k) {
      for (double share = 0; share <= 1; share += 0.01) {
        const FieldPoint at = way[k - 1] + FieldVector{share * (way[k] - way[k - 1]).x,
                                                       share * (way[k] - way[k - 1]).y};
        CHECK(distance(at, at_m(150, 94)) > metres(5));
      }
    }
  }
  CHECK(between_parts == 1);
}

TEST_CASE("plan_fleet: the same problem gives the same plan", "[scheduler]") {
  const FleetProblem p = problem(80, 300, 3);
  const auto a = plan_fleet(p), b = plan_fleet(p);
  REQUIRE(a);
  REQUIRE(b);
  CHECK(a->makespan_s == b->makespan_s);
  for (std::size_t u = 0; u < 3; ++u) {
    CHECK(a->uavs[u].strips == b->uavs[u].strips);
    CHECK(a->uavs[u].solution.plan.returns == b->uavs[u].solution.plan.returns);
  }
}

TEST_CASE("plan_fleet: searches the work direction when it is left out", "[scheduler]") {
  // 20 m by 400 m: strips along the length, 0 or 180 degrees, need fewer turns and returns.
  FleetProblem p = problem(20, 400, 2);
  p.work_direction_deg.reset();
  p.solver.returns = ReturnStrategy::unplanned;
  const auto searched = plan_fleet(p);
  REQUIRE(searched);
  for (const double direction_deg : {0.0, 90.0, 180.0, 270.0}) {
    p.work_direction_deg = direction_deg;
    const auto given = plan_fleet(p);
    REQUIRE(given);
    if (direction_deg == searched->work_direction_deg) {
      CHECK(given->makespan_s == searched->makespan_s);
    }
  }
}

TEST_CASE("plan_fleet: aircraft use the station near their share", "[scheduler]") {
  FleetProblem p = problem(400, 200, 4);
  p.stations = {station(1, 1, at_m(0, 0)), station(2, 1, at_m(400, 0))};
  const auto plan = plan_fleet(p);
  REQUIRE(plan);
  CHECK(plan->uavs.front().station.id == StationId{1});
  CHECK(plan->uavs.back().station.id == StationId{2});
}

TEST_CASE("plan_fleet: more aircraft than strips leave some on the ground", "[scheduler]") {
  const auto plan = plan_fleet(problem(4, 100, 3));
  REQUIRE(plan);
  CHECK(plan->uavs[2].cells.count == 0);
  CHECK(plan->uavs[2].solution.plan.sorties.empty());
  CHECK(plan->uavs[2].lands_s == 0);
}

TEST_CASE("plan_fleet: says which aircraft cannot fly the plan", "[scheduler]") {
  FleetProblem p = problem(20, 100, 2);
  p.vehicles[1].swath = metres(3);
  const auto swaths = plan_fleet(p);
  REQUIRE_FALSE(swaths);
  CHECK(swaths.error().fault == PlanFault::swaths_differ);
  CHECK(swaths.error().detail.rfind("UAV 2 sprays 3", 0) == 0);

  p = problem(20, 100, 2);
  p.vehicles[1].spray_endurance = seconds(0.5);
  const auto tank = plan_fleet(p);
  REQUIRE_FALSE(tank);
  CHECK(tank.error().fault == PlanFault::tank_too_small);

  p = problem(20, 100, 2);
  p.stations[0].position = at_m(0, 90'000);
  const auto reach = plan_fleet(p);
  REQUIRE_FALSE(reach);
  CHECK(reach.error().fault == PlanFault::out_of_reach);
}

TEST_CASE("plan_fleet: aircraft fly within the time that they are available for", "[scheduler]") {
  FleetProblem p = problem(60, 400, 3);
  p.solver.returns = ReturnStrategy::joint;
  const auto free = plan_fleet(p);
  REQUIRE(free);
  const Seconds half = seconds(0.5 * free->makespan_s);
  p.vehicles[1].available_from = half;
  p.vehicles[2].available_until = half;
  const auto plan = plan_fleet(p);
  REQUIRE(plan);
  CHECK(plan->makespan_s > free->makespan_s);
  CHECK(plan->lower_bound_s > 0);  // one that a plan refutes is forgotten
  CHECK(plan->lower_bound_s <= plan->makespan_s);
  CHECK(plan->uavs[1].spray_ends_s > half.base());
  // A twenty-fifth of its window is kept.
  CHECK(plan->uavs[2].cells.count > 0);
  CHECK(plan->uavs[2].lands_s <= 0.96 * half.base());
  std::uint32_t cells = 0;
  for (const UavPlan& u : plan->uavs) cells += u.cells.count;
  CHECK(cells == plan->route.centers.size());

  for (Vehicle& v : p.vehicles) v.available_until = half;
  const auto impossible = plan_fleet(p);
  REQUIRE_FALSE(impossible);
  CHECK(impossible.error().fault == PlanFault::window_too_short);
}

TEST_CASE("plan_fleet: packs carry flights as they are flown, of one aircraft too", "[scheduler]") {
  // Rows of 100 m are sprayed in 33 s, and each turn to the next takes some seconds that plans of
  // constant speed leave out: sorties that fill a pack of 200 s by those do not come home on it.
  FleetProblem p = problem(60, 100, 1);
  p.solver.returns = ReturnStrategy::joint;
  p.vehicles[0].flight_endurance = seconds(200);
  const auto plan = plan_fleet(p);
  REQUIRE(plan);
  for (const planner::PlannedSortie& s : plan->uavs[0].solution.plan.sorties) {
    CHECK(200 * s.battery_used <= longest_flight_s(p.vehicles[0]));
  }
}

TEST_CASE("plan_fleet: each place of a field in reach of some station is enough", "[scheduler]") {
  // Rows of 4 km. A pack lasts for 900 s at 6 m/s: half way there and back from either end, not
  // from one end to the other and back.
  FleetProblem p = problem(4000, 8, 2);
  p.work_direction_deg = 90.0;
  p.solver.returns = ReturnStrategy::joint;
  p.stations.push_back(station(2, 1, at_m(4000, 0)));
  for (Vehicle& v : p.vehicles) v.flight_endurance = seconds(900);
  const auto plan = plan_fleet(p);
  REQUIRE(plan);
  CHECK_FALSE(plan->yardsticks->shares_s);
  CHECK(plan->yardsticks->is_joint);
  for (Vehicle& v : p.vehicles) v.flight_endurance = seconds(600);
  const auto beyond = plan_fleet(p);
  REQUIRE_FALSE(beyond);
  CHECK(beyond.error().fault == PlanFault::out_of_reach);
}

// Services of a plan that begin before a station opens, or end after plans have them done there.
std::size_t outside_hours(const FleetPlan& plan, const std::vector<Station>& stations) {
  std::size_t outside = 0;
  for (const UavPlan& uav : plan.uavs) {
    for (std::size_t n = 0; n < uav.visits.size(); ++n) {
      const Station& at = stations.at(number(landing(uav, n).id) - 1);
      const auto until = planned_until(at);
      outside += uav.visits[n].starts_s < at.available_from.base() ||
                 (until && uav.visits[n].ready_s > until->base());
    }
  }
  return outside;
}

TEST_CASE("plan_fleet: aircraft are served within the hours of stations", "[scheduler]") {
  FleetProblem p = problem(60, 400, 2);
  p.solver.returns = ReturnStrategy::joint;
  p.stations.push_back(station(2, 1, at_m(60, 0)));
  const auto free = plan_fleet(p);
  REQUIRE(free);
  const Seconds half = seconds(0.5 * free->makespan_s);
  p.stations[0].available_from = p.stations[1].available_from = half;
  p.stations[1].available_until = half + seconds(100);
  CHECK(outside_hours(*free, p.stations) > 0);
  const auto plan = plan_fleet(p);
  REQUIRE(plan);
  CHECK(outside_hours(*plan, p.stations) == 0);
  CHECK(plan->lower_bound_s <= plan->makespan_s);
}

TEST_CASE("plan_fleet: services that fit no station's hours are refused with the station",
          "[scheduler]") {
  // 60 rows of 400 m are 24 km, a tank lasts for 2.7 km: who flies alone comes back after 900 s.
  FleetProblem p = problem(60, 400, 1);
  p.stations[0].available_until = seconds(300);
  const auto plan = plan_fleet(p);
  REQUIRE_FALSE(plan);
  CHECK(plan.error().fault == PlanFault::hours_too_short);
  CHECK(plan.error().at == p.stations[0].position);
  CHECK(plan.error().detail.find("it closes at 300.0 s") != std::string::npos);
}

}  // namespace
}  // namespace furrow::scheduler
