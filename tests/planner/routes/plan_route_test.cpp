#include "planner/routes/plan_route.hpp"

#include "tests/planner/routes/hills.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

// Enough for the wall below; the plain algorithm misses it in ten times as many.
constexpr std::uint64_t evaluations = 1500;

// A wall of 60 m across the middle, open over its last 200 m and under a ceiling of 50 m: the way
// leads round its end.
Scene walled() {
  Raster ground{.south_west = at_m(0, 0),
                .step = metres(20),
                .columns = 51,
                .rows = 51,
                .heights_m = std::vector<float>(51 * 51, 0.0f)};
  for (std::uint32_t j = 0; j <= 40; ++j) ground.heights_m[j * 51 + 25] = 60;
  return {.surface = Surface{ground},
          .low = {0, 0, 0},
          .high = {1000, 1000, 50},
          .clearance_m = 5,
          .start = {100, 700, 20},
          .goal = {900, 700, 20}};
}

TEST_CASE("Every planner but the plain algorithm finds the way round a wall, and finds it again") {
  // Wall and its slopes reach to y = 820 at 0 m, so the shortest way passes x = 500 near y = 820:
  // 2 hypot(400, 120) = 835 m, a little less over the wall's sloping end. A detour of half as much
  // again is still a way.
  const Scene scene = walled();
  for (const RoutePlanner planner : route_planners) {
    if (planner == RoutePlanner::plain_ga) continue;
    INFO(name(planner));
    const RouteSettings settings{.planner = planner, .evaluations = evaluations, .seed = 3};
    const auto route = plan_route(scene, settings);
    INFO((route ? "" : route.error()));
    REQUIRE(route);
    CHECK(route->cost.length_m > 815);
    CHECK(route->cost.length_m < 1250);
    CHECK(is_clear_throughout(scene, route->genes, 1));
    CHECK(plan_route(scene, settings)->genes == route->genes);
  }
}

TEST_CASE("Where the straight line is clear, it is the route") {
  Scene scene = walled();
  scene.start.y_m = scene.goal.y_m = 950;
  const auto route = plan_route(scene, {.planner = RoutePlanner::improved_ga});
  REQUIRE(route);
  CHECK(route->genes.empty());
  CHECK(route->cost.total() == Approx(800));
}

TEST_CASE("What cannot be flown is refused with the reason") {
  Scene scene = walled();
  scene.start.z_m = 4;
  CHECK(plan_route(scene, {}).error() ==
        "start (100.0, 700.0) at 4.0 m must be in the box, outside volumes and 5.0 m above the "
        "terrain at 0.0 m");
  scene = walled();
  Raster closed = scene.surface.raster();
  for (std::uint32_t j = 0; j < 51; ++j) closed.heights_m[j * 51 + 25] = 60;
  scene.surface = Surface{closed};
  const auto route = plan_route(scene, {.evaluations = 500});
  REQUIRE(!route);
  CHECK(
      route.error().starts_with("no clear route from (100.0, 700.0) to (900.0, 700.0) found by "
                                "lattice in 500 evaluations"));
}

TEST_CASE("A search spends its budget and little more") {
  const Scene scene = hills::scene(1);
  for (const RoutePlanner planner : route_planners) {
    INFO(name(planner));
    const RouteSearch search =
        search_route(scene, {.planner = planner, .evaluations = 1000, .seed = 1});
    CHECK(search.evaluations < 1000 + 40 * 7);
    RouteJudge judge{scene};
    CHECK(judge.cost(search.best.genes).total() == search.best.cost.total());
  }
}

// Planned routes are clear at every half metre; refusals say why. Returns the routes found.
int feasible(std::uint64_t first, std::uint64_t last) {
  int found = 0;
  for (std::uint64_t number = first; number < last; ++number) {
    const Scene scene = hills::scene(number, number % 5);
    const auto route = plan_route(scene, {.evaluations = 3000, .seed = number});
    if (!route) {
      CHECK_FALSE(route.error().empty());
      continue;
    }
    ++found;
    const AnalyticTerrain truth = hills::terrain(number);
    for (const WayPoint& p : flown(scene, route->genes)) {
      REQUIRE(p.z_m >= height(truth, at_m(p.x_m, p.y_m)).base() + scene.clearance_m);
      REQUIRE(is_clear(scene, p));
    }
  }
  return found;
}

TEST_CASE("Routes of random scenes keep terrain, box and volumes, or are refused") {
  CHECK(feasible(1000, 1020) >= 15);
}

TEST_CASE("Routes of a thousand random scenes keep all rules", "[.sweep]") {
  const int found = feasible(0, 1000);
  WARN(found << " of 1000 scenes have a route");
  CHECK(found >= 800);
}

}  // namespace
}  // namespace furrow::planner
