#include "planner/returns/stops.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow;
using namespace furrow::planner;

namespace {

// 4 m/s at work, 8 m/s on ferries; brakes and gathers speed at 0.95 3 = 2.85 m/s2.
Vehicle sprayer() {
  return {.id = AgentId{1},
          .home = at_m(0, 0),
          .swath = metres(4),
          .spray_speed = metres_per_second(4),
          .ferry_speed = metres_per_second(8),
          .spray_endurance = seconds(500),
          .flight_endurance = seconds(1200),
          .battery_reserve = 0.1,
          .tank = litres(10),
          .min_turn_radius = {},
          .acceleration_limit = metres_per_second2(3),
          .gnss = {}};
}

Strip line(FieldPoint from, FieldPoint to) { return end_strip({0, 10}, from, to, {}); }

}  // namespace

TEST_CASE("between rows an aircraft loses two ramps and a leg from rest to rest") {
  // 4^2 / (2 2.85 4) = 0.702 s for each ramp; 4 m from rest to rest take 2 sqrt(4 / 2.85) = 2.369 s
  // instead of 0.5 s.
  const double loss_s =
      joint_loss_s(line(at_m(0, 0), at_m(0, 100)), line(at_m(4, 100), at_m(4, 0)), sprayer());
  CHECK(loss_s == Approx(2 * 16 / (2 * 2.85 * 4) + 2 * std::sqrt(4 / 2.85) - 0.5));
}

TEST_CASE("where rows meet in one line nothing is lost") {
  CHECK(joint_loss_s(line(at_m(0, 0), at_m(0, 50)), line(at_m(0, 50), at_m(0, 100)), sprayer()) ==
        Approx(0).margin(1e-12));
}

TEST_CASE("cells walked around a corner lose little: arcs are shorter than corners") {
  // Arcs of 2 m at both ends of a step of 4 m, at sqrt(0.9 2.85 2) = 2.265 m/s: pi 2 / 2 each
  // in 1.387 s instead of 4 m in 1 s; ramps of (4 - 2.265)^2 / (2 2.85 4) = 0.132 s. No leg is left
  // between them.
  const Strip up = centre_strip({0, 25}, at_m(2, 2), at_m(2, 98), false);
  const Strip down = centre_strip({25, 25}, at_m(6, 98), at_m(6, 2), true);
  const double arc_mps = std::sqrt(0.9 * 2.85 * 2);
  const double ramp_s = std::pow(4 - arc_mps, 2) / (2 * 2.85 * 4);
  CHECK(joint_loss_s(up, down, sprayer()) == Approx(2 * (M_PI / arc_mps - 1 + ramp_s)));
}

TEST_CASE("a ferry to the end of a row loses ramps at its start, at its stop and into work") {
  // 8 / (2 2.85) twice and 4 / (2 2.85).
  CHECK(ferry_loss_s(line(at_m(0, 0), at_m(0, 100)), sprayer()) == Approx(20 / (2 * 2.85)));
}
