#include "planner/routes/route_cost.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

// Level ground at 0, 5 m of clearance, straight on at 10 m over 1000 m.
Scene plain() {
  return {.surface = Surface::level(metres(0)),
          .low = {-10, -200, 0},
          .high = {1010, 200, 100},
          .clearance_m = 5,
          .start = {0, 0, 10},
          .goal = {1000, 0, 10}};
}

TEST_CASE("A clear straight route costs its length") {
  const Scene scene = plain();
  RouteJudge judge{scene};
  const RouteCost cost = judge.cost({});
  CHECK(cost.length_m == Approx(1000));
  CHECK(cost.is_feasible());
  CHECK(cost.total() == cost.length_m);
  CHECK(judge.evaluations() == 1);
}

TEST_CASE("Each sample under the clearance costs a twentieth of the way and its depth") {
  // Ground at 8: 10 m lies 3 m under 8 + 5. All 101 samples: 101 * (50 + 10 * 3).
  Scene scene = plain();
  scene.surface = Surface::level(metres(8));
  const RouteCost cost = RouteJudge{scene}.cost({});
  CHECK(cost.terrain == Approx(101 * 80));
  CHECK(cost.outside == 0);
  CHECK_FALSE(cost.is_feasible());
}

TEST_CASE("The error of the surface widens the clearance") {
  Scene scene = plain();
  const Raster ground{.south_west = at_m(0, 0),
                      .step = metres(1),
                      .columns = 2,
                      .rows = 2,
                      .heights_m = {4.5f, 4.5f, 4.5f, 4.5f}};
  scene.surface = Surface{ground};
  CHECK(RouteJudge{scene}.cost({}).is_feasible());  // 10 >= 4.5 + 5
  scene.surface = Surface{ground, metres(1)};
  CHECK_FALSE(RouteJudge{scene}.cost({}).is_feasible());
}

TEST_CASE("Samples outside the box and inside a volume cost alike") {
  Scene scene = plain();
  scene.high.z_m = 8;  // every sample 2 m too high
  CHECK(RouteJudge{scene}.cost({}).outside == Approx(101 * (50 + 20)));
  // A cylinder of 25 m around x = 500: samples at 480, 490, 500, 510, 520, at depths 5, 15, 25,
  // 15, 5; its ceiling at 30 leaves 20 m upwards.
  scene = plain();
  scene.keep_out = {{.x_m = 500, .y_m = 0, .radius_m = 25, .top_m = 30}};
  CHECK(RouteJudge{scene}.cost({}).outside == Approx(5 * 50 + 10 * (5 + 15 + 20 + 15 + 5)));
  scene.keep_out.front().top_m = 9;  // passes beneath the route
  CHECK(RouteJudge{scene}.cost({}).is_feasible());
}

TEST_CASE("Climbs too steep and bends too sharp are no route") {
  Scene scene = plain();
  scene.goal.z_m = 90;  // 80 m over 1000 m: 0.08
  scene.steepest_climb = 0.081;
  CHECK(RouteJudge{scene}.cost({}).is_feasible());
  scene.steepest_climb = 0.04;  // twice as steep as allowed: once the straight distance
  CHECK(RouteJudge{scene}.cost({}).limits ==
        Approx(distance_m(scene.start, scene.goal)).epsilon(1e-6));

  // By (500, 100): spans of 500 m, bend 2 (y'' = -300, x' = 500): curvature 300 / 500^2, 1 / 833 m.
  const WayPoint by{500, 100, 10};
  scene = plain();
  scene.least_turn_radius_m = 830;
  CHECK(RouteJudge{scene}.cost({&by, 1}).is_feasible());
  scene.least_turn_radius_m = 840;
  CHECK(RouteJudge{scene}.cost({&by, 1}).limits > 0);
}

TEST_CASE("Looking up places is counted by the hundred and one") {
  const Scene scene = plain();
  RouteJudge judge{scene};
  for (int i = 0; i < 101; ++i) judge.is_clear({500, 0, 10});
  CHECK(judge.evaluations() == Approx(1));
  CHECK(judge.is_clear({0, 0, 10}, {1000, 0, 10}, 10));
  CHECK(judge.evaluations() == Approx(2));
  CHECK_FALSE(judge.is_clear({500, 0, 4.9}));
}

}  // namespace
}  // namespace furrow::planner
