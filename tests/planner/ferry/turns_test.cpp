#include "planner/ferry/turns.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

Vehicle aircraft() {
  Vehicle v{};
  v.swath = metres(4);
  v.ferry_speed = metres_per_second(10);
  v.acceleration_limit = metres_per_second2(10 / 0.95);  // 10 m/s2 planned
  return v;
}

TEST_CASE("A right angle is turned on an arc that half a swath allows") {
  // The arc takes 2 m of each leg, its radius is 2 m, its speed sqrt(0.9 * 10 * 2) = 4.2426 m/s:
  // (10 - 4.2426)^2 / (10 * 10) + 2 * 1.5708 / 4.2426 - 4 / 10 = 0.3315 + 0.7405 - 0.4 s.
  const double loss_s =
      turn_loss_s(at_m(0, 0), at_m(100, 0), at_m(100, 50), Corner::cut, aircraft());
  CHECK(loss_s == Approx(0.6720).margin(1e-4));
}

TEST_CASE("Straight on, and from a place to itself, nothing is lost") {
  CHECK(turn_loss_s(at_m(0, 0), at_m(9, 0), at_m(20, 0), Corner::cut, aircraft()) == 0);
  CHECK(turn_loss_s(at_m(9, 0), at_m(9, 0), at_m(9, 5), Corner::cut, aircraft()) == 0);
}

TEST_CASE("A corner turned at a stop loses what coming to rest and going on do") {
  // 10 m/s at 10 m/s2: 1 s each way over 5 m, which full speed flies in 0.5 s.
  CHECK(rest_loss_s(aircraft()) == Approx(0.5));
  CHECK(turn_loss_s(at_m(0, 0), at_m(9, 0), at_m(9, 5), Corner::held, aircraft()) == Approx(1));
}

}  // namespace
}  // namespace furrow::planner
