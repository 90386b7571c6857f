#include "scheduler/steep_ways.hpp"

#include "scheduler/fleet_problem.hpp"
#include "scheduler/plan_fleet.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace furrow::scheduler {
namespace {

// Level up to y = 100 m, from there on 0.5 m up per metre northwards.
planner::TerrainModel ramp(double climb_mps, double slowest) {
  Raster ground{
      .south_west = at_m(-100, -100), .step = metres(50), .columns = 5, .rows = 8, .heights_m = {}};
  for (int row = 0; row < 8; ++row) {
    const auto height_m = static_cast<float>(0.5 * std::max(0, row * 50 - 200));
    ground.heights_m.insert(ground.heights_m.end(), 5, height_m);
  }
  const Speed vertical = metres_per_second(climb_mps);
  return {.ground = ground,
          .rule = {.climb = vertical, .descent = vertical, .slowest = slowest},
          .keep_out = {}};
}

// Nine rows of 200 m northwards, 2 m apart, half of each over the ramp; the station is at (0, 0).
FleetPlan planned(const std::optional<planner::TerrainModel>& terrain) {
  FleetProblem p{.field = {.boundary = {at_m(0, 0), at_m(18, 0), at_m(18, 200), at_m(0, 200)},
                           .holes = {},
                           .obstacles = {}},
                 .coverage = {},
                 .work_direction_deg = 0.0,
                 .stations = {station(1)},
                 .vehicles = {vehicle(1)},
                 .solver = {.returns = planner::ReturnStrategy::simple,
                            .refine = false,
                            .paper_counting = false,
                            .iterations = 1,
                            .masses = 2,
                            .budget_s = 1,
                            .seed = 1}};
  p.terrain = terrain;
  auto plan = plan_fleet(p);
  REQUIRE(plan);
  return std::move(*plan);
}

TEST_CASE("steep ways: rows that climb faster than aircraft do are told, with the first place",
          "[scheduler]") {
  // At 3 m/s, the least speed, 0.5 m per metre are 1.5 m/s. Pieces are 20 m long at most.
  const SteepWays steep = steep_ways(planned(ramp(1.0, 1.0)));
  CHECK(steep.rows.length_m == Approx(9 * 100).margin(9 * 20));
  REQUIRE(steep.rows.first);
  CHECK(steep.rows.first->x.base() == Approx(1));
  CHECK(steep.rows.first->y.base() == Approx(100).margin(20));
  // Aircraft come down from the last row over all of the ramp, never below the height of work.
  CHECK(steep.between.length_m > 0);
  REQUIRE(steep.between.first);
  CHECK(steep.between.first->y.base() > 80);
}

TEST_CASE("steep ways: where aircraft may slow down enough, and on level land, there are none",
          "[scheduler]") {
  // A quarter of 3 and of 6 m/s: up and down at 0.75 m/s at most.
  for (const SteepWays& none : {steep_ways(planned(ramp(1.0, 0.25))), steep_ways(planned({}))}) {
    CHECK(none.rows.length_m == 0);
    CHECK_FALSE(none.rows.first);
    CHECK(none.between.length_m == 0);
    CHECK_FALSE(none.between.first);
  }
}

}  // namespace
}  // namespace furrow::scheduler
