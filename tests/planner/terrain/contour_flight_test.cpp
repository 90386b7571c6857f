#include "planner/terrain/contour_flight.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

const ContourRule rule{.height = metres(3),
                       .spray_speed = metres_per_second(5),
                       .slowest = metres_per_second(1),
                       .climb = metres_per_second(2),
                       .descent = metres_per_second(1.5)};

// 100 m level, 100 m rising at `slope`, 100 m falling again, eastwards.
Surface roof(double slope) {
  const auto top = static_cast<float>(100 * slope);
  return Surface{{.south_west = at_m(0, 0),
                  .step = metres(100),
                  .columns = 4,
                  .rows = 2,
                  .heights_m = {0, 0, top, 0, 0, 0, top, 0}}};
}

ContourFlight over(double slope) {
  return contour_flight(roof(slope), at_m(0, 50), at_m(300, 50), rule);
}

TEST_CASE("A gentle slope is followed at full speed, at the height above the ground") {
  // 5 m/s at a slope of 0.2 climbs 1 m/s.
  const ContourFlight flight = over(0.2);
  CHECK(flight.duration.base() == Approx(60));
  CHECK(flight.too_steep == metres(0));
  for (const ContourPoint& p : flight.points) {
    const double ground_m = roof(0.2).height(at_m(p.along.base(), 50)).base();
    CHECK(p.altitude.base() == Approx(ground_m + 3));
  }
}

TEST_CASE("A steep slope is followed as fast as climb and descent allow") {
  // Slope 1: up at 2 m/s in 50 s, down at 1.5 m/s in 66.67 s, after 20 s on the level.
  const ContourFlight flight = over(1);
  CHECK(flight.duration.base() == Approx(20 + 50 + 100 / 1.5));
  CHECK(flight.too_steep == metres(0));
}

TEST_CASE("Where the aircraft would have to hover along, the length is said") {
  // Slope 1.8: up needs 2 / 1.8 = 1.11 m/s, down 1.5 / 1.8 = 0.83 m/s, which is under 1 m/s.
  const ContourFlight flight = over(1.8);
  CHECK(flight.too_steep.base() == Approx(100));
  CHECK(flight.duration.base() == Approx(20 + 100 * 1.8 / 2 + 100));
}

TEST_CASE("A slanting strip has a point wherever it crosses the raster") {
  const ContourFlight flight = contour_flight(roof(0.1), at_m(50, -50), at_m(250, 150), rule);
  // Crossings at x = 100, 200 and y = 0, 100, which coincide in pairs (x - y = 100); halves
  // between.
  REQUIRE(flight.points.size() == 7);
  CHECK(flight.points.front().along == metres(0));
  CHECK(flight.points.back().along.base() == Approx(200 * std::sqrt(2.0)));
}

}  // namespace
}  // namespace furrow::planner
