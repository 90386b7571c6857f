#include "planner/routes/reach_map.hpp"

#include "planner/routes/route_cost.hpp"
#include "tests/planner/routes/hills.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

const AirSpeeds speeds{
    .level_mps = 10, .climb_mps = 3, .descent_mps = 2, .climb_energy_s_per_m = 0.5};

TEST_CASE("A leg takes as long as its slowest part, and climbing takes more from the pack") {
  // 100 m on and 60 m up: length 116.6 m, 11.7 s; the climb takes 20 s. Pack: 20 + 0.5 * 60.
  const WayPoint a{0, 0, 0}, b{100, 0, 60};
  CHECK(flight_cost(a, b, speeds).time_s == Approx(20));
  CHECK(flight_cost(a, b, speeds).energy_s == Approx(50));
  CHECK(flight_cost(b, a, speeds).time_s == Approx(30));  // down at 2 m/s
  CHECK(flight_cost(b, a, speeds).energy_s == Approx(30));
}

TEST_CASE("Over level ground every cell is reached about straight") {
  const Scene scene{.surface = Surface::level(metres(0)),
                    .low = {0, 0, 0},
                    .high = {500, 500, 20},
                    .clearance_m = 5,
                    .start = {250, 250, 10},
                    .goal = {}};
  const ReachMap map{scene, speeds, 26, 26, 5};
  for (std::size_t c = 0; c < map.cells(); ++c) {
    REQUIRE(map.is_reached(c));
    const std::vector<WayPoint> way = map.way(c);
    const double straight_s = distance_m(scene.start, way.back()) / speeds.level_mps;
    CHECK(map.out(c).time_s >= straight_s - 1e-9);
    CHECK(map.out(c).time_s <= straight_s + 2.5 + 1e-6);  // 5 m down at 2 m/s
  }
}

TEST_CASE("Ways over hills are clear, and cost what is said both ways") {
  const Scene scene = hills::scene(3, 4);
  const ReachMap map{scene, speeds, 41, 41, 8};
  std::size_t reached = 0;
  for (std::size_t c = 0; c < map.cells(); ++c) {
    if (!map.is_reached(c)) continue;
    ++reached;
    const std::vector<WayPoint> way = map.way(c);
    RouteJudge judge{scene};
    FlightCost out{}, back{};
    for (std::size_t i = 1; i < way.size(); ++i) {
      REQUIRE(judge.is_clear(way[i - 1], way[i], 12.5));
      out = out + flight_cost(way[i - 1], way[i], speeds);
      back = back + flight_cost(way[i], way[i - 1], speeds);
    }
    REQUIRE(map.out(c).time_s == Approx(out.time_s));
    REQUIRE(map.back(c).energy_s == Approx(back.energy_s));
  }
  CHECK(reached > map.cells() / 2);
}

TEST_CASE("A cell in a keep-out volume is not reached") {
  Scene scene{.surface = Surface::level(metres(0)),
              .low = {0, 0, 0},
              .high = {500, 500, 20},
              .clearance_m = 5,
              .start = {10, 10, 10},
              .goal = {}};
  scene.keep_out = {{.x_m = 250, .y_m = 250, .radius_m = 60}};
  const ReachMap map{scene, speeds, 26, 26, 5};
  CHECK_FALSE(map.is_reached(map.cell(250, 250)));
  // Straight behind the volume: round it, so longer than straight, hypot(480, 480) = 679 m.
  const std::size_t behind = map.cell(490, 490);
  REQUIRE(map.is_reached(behind));
  CHECK(map.out(behind).time_s > 68.5);
  CHECK(map.out(behind).time_s < 75);
}

}  // namespace
}  // namespace furrow::planner
