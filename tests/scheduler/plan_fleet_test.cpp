#include "scheduler/plan_fleet.hpp"

#include "core/random.hpp"
#include "planner/coverage/swath/swath.hpp"
#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"
#include "scheduler/fleet_ferries.hpp"
#include "scheduler/forecast.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

#include <functional>

namespace furrow::scheduler {
namespace {

using planner::PlanFault;
using planner::ReturnStrategy;

FleetProblem problem(double width_m, double length_m, std::uint32_t uavs) {
  FleetProblem p{.field = {.boundary = {at_m(0, 0), at_m(width_m, 0), at_m(width_m, length_m),
                                        at_m(0, length_m)},
                           .holes = {},
                           .obstacles = {}},
                 .coverage = {},
                 .work_direction_deg = 0.0,
                 .stations = {station(1)},
                 .vehicles = {},
                 .solver = {.returns = ReturnStrategy::gsa,
                            .refine = true,
                            .paper_counting = false,
                            .iterations = 20,
                            .masses = 10,
                            .budget_s = 1,
                            .seed = 1}};
  for (std::uint32_t i = 1; i <= uavs; ++i) p.vehicles.push_back(vehicle(i));
  return p;
}

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

planner::TerrainModel hill(FieldPoint top, double height_m) {
  planner::AnalyticTerrain ground{.base = {},
                                  .peaks = {{top, metres(height_m), metres(60), metres(60)}}};
  return {.ground = ground, .rule = {}, .keep_out = {}};
}

TEST_CASE("plan fleet: over a hill the same sorties take longer, and more of the packs",
          "[scheduler]") {
  FleetProblem p = problem(60, 200, 1);
  p.solver.returns = ReturnStrategy::exact;
  const auto level = plan_fleet(p);
  p.terrain = hill(at_m(30, 100), 40);
  const auto hilly = plan_fleet(p);
  REQUIRE(level);
  REQUIRE(hilly);
  CHECK(hilly->makespan_s > level->makespan_s);
  CHECK(hilly->lower_bound_s <= hilly->makespan_s);
  const auto used = [](const FleetPlan& plan) {
    double sum = 0;
    for (const auto& sortie : plan.uavs[0].solution.plan.sorties) sum += sortie.battery_used;
    return sum;
  };
  CHECK(used(*hilly) > used(*level));
  CHECK(hilly->route.ferries.relief() != nullptr);
}

TEST_CASE("plan fleet: level ground by formula costs the climb to the clearance alone",
          "[scheduler]") {
  FleetProblem p = problem(40, 100, 1);
  p.solver.returns = ReturnStrategy::exact;
  const auto level = plan_fleet(p);
  p.terrain = hill(at_m(5000, 5000), 40);  // beyond the horizon
  const auto flat = plan_fleet(p);
  REQUIRE(level);
  REQUIRE(flat);
  CHECK(flat->makespan_s == Approx(level->makespan_s));
  const auto& a = level->uavs[0].solution.plan;
  const auto& b = flat->uavs[0].solution.plan;
  CHECK(a.returns == b.returns);
  CHECK(b.sorties.front().battery_used > a.sorties.front().battery_used);
}

TEST_CASE("plan fleet: a ceiling under the ferries and a volume over the field are refused",
          "[scheduler]") {
  FleetProblem p = problem(60, 200, 1);
  p.terrain = hill(at_m(30, 100), 40);
  p.terrain->rule.ceiling = metres(50);  // 40 m of hill and 15 m of clearance
  const auto low = plan_fleet(p);
  REQUIRE(!low);
  CHECK(low.error().fault == PlanFault::ceiling_too_low);
  p.terrain->rule.ceiling = metres(60);
  CHECK(plan_fleet(p));
  p.terrain->keep_out = {{.x_m = 65, .y_m = 100, .radius_m = 6}};
  const auto kept_out = plan_fleet(p);
  REQUIRE(!kept_out);
  CHECK(kept_out.error().fault == PlanFault::kept_out);
  CHECK(kept_out.error().at == at_m(65, 100));
  CHECK(kept_out.error().detail ==
        "the keep-out volume at (65.000, 100.000) m reaches over the field");
}

TEST_CASE("plan fleet: ferries lead around a keep-out volume between station and field",
          "[scheduler]") {
  FleetProblem p = problem(200, 100, 1);
  p.stations[0].position = p.vehicles[0].home = at_m(100, -80);
  p.terrain = hill(at_m(5000, 5000), 40);
  p.terrain->keep_out = {{.x_m = 100, .y_m = -40, .radius_m = 20}};
  const auto map = ferry_map(p);
  REQUIRE(map);
  const auto way = map->way(at_m(100, -80), at_m(100, 50));
  double length_m = 0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    for (double t = 0; t <= 1; t += 0.01) {
      const FieldVector leg = way[i] - way[i - 1];
      const FieldPoint at = way[i - 1] + FieldVector{t * leg.x, t * leg.y};
      CHECK(distance(at, at_m(100, -40)).base() >= 20);
    }
    length_m += distance(way[i - 1], way[i]).base();
  }
  CHECK(length_m > 130);
}

TEST_CASE("plan fleet: a keep-out volume over a station is named with what ferries keep of it",
          "[scheduler]") {
  FleetProblem p = problem(200, 100, 1);
  p.stations[0].position = p.vehicles[0].home = at_m(100, -80);
  p.terrain = hill(at_m(5000, 5000), 40);
  p.terrain->keep_out = {{.x_m = 100, .y_m = -60, .radius_m = 20}};
  const auto map = ferry_map(p);
  REQUIRE(!map);
  CHECK(map.error().fault == PlanFault::kept_out);
  CHECK(map.error().at == at_m(100, -60));
  CHECK_THAT(map.error().detail, Catch::StartsWith("the keep-out volume at (100.000, -60.000) m "
                                                   "reaches over (100.000, -80.000) m"));
}

TEST_CASE("plan fleet: keep-out volumes above all ferries and below work are no matter",
          "[scheduler]") {
  FleetProblem p = problem(200, 100, 1);
  p.terrain = hill(at_m(5000, 5000), 40);  // level here, at 0 m; ferries keep 15 m, work 3 m
  const auto planned = [&](double bottom_m, double top_m) {
    p.terrain->keep_out = {
        {.x_m = 100, .y_m = 50, .radius_m = 20, .bottom_m = bottom_m, .top_m = top_m}};
    return ferry_map(p).has_value();
  };
  CHECK(planned(-10, 2.9));
  CHECK_FALSE(planned(-10, 3.1));
  CHECK(planned(200, 300));
  CHECK_FALSE(planned(14, 300));
}

TEST_CASE("plan fleet: a keep-out volume at the survey's height over a way point is refused",
          "[scheduler]") {
  FleetProblem p = problem(200, 100, 1);
  p.terrain = hill(at_m(100, 50), 40);  // the survey passes its top at 70 m
  p.terrain->rule.spray_height = metres(30);
  p.survey =
      planner::SurveySettings{.way_points = {at_m(20, 20), at_m(100, 50)}, .height = metres(30)};
  const auto planned = [&](double x_m, double bottom_m, double top_m) {
    p.terrain->keep_out = {
        {.x_m = x_m, .y_m = 50, .radius_m = 5, .bottom_m = bottom_m, .top_m = top_m}};
    return ferry_map(p);
  };
  const auto over = planned(104, 0, 100);
  REQUIRE(!over);
  CHECK(over.error().fault == PlanFault::kept_out);
  CHECK(over.error().at == at_m(104, 50));
  CHECK(
      over.error().detail ==
      "the keep-out volume at (104.000, 50.000) m reaches over the way point (100.000, 50.000) m");
  // Ways of aircraft with 2 m of swath keep 1 m, so 6 m from the axis.
  const auto near = planned(105.5, 0, 100);
  REQUIRE(!near);
  CHECK_THAT(near.error().detail, Catch::EndsWith("is 0.500 m from the way point (100.000, 50.000) "
                                                  "m; surveys keep 1.000 m"));
  CHECK(planned(106.5, 0, 100));
  CHECK_FALSE(planned(104, 0, 71));
  CHECK(planned(104, 0, 69));  // below the survey there, whatever ferries meet
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

}  // namespace
}  // namespace furrow::scheduler
