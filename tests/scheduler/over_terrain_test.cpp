#include "scheduler/fleet_ferries.hpp"
#include "scheduler/plan_fleet.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

using planner::PlanFault;
using planner::ReturnStrategy;

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

}  // namespace
}  // namespace furrow::scheduler
