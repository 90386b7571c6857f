#include "planner/avoidance/detour.hpp"

#include "core/random.hpp"
#include "planner/avoidance/taut.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow;
using namespace furrow::planner;

namespace {

PassedCircle circle_for(Beside obstacle, double x_m, double turn_m, Side side) {
  const Beside c = replaced(obstacle, metres(turn_m), side);
  return {{x_m, c.left.base()}, c.radius.base(), side};
}

}  // namespace

TEST_CASE("the obstacle circle is the obstacle and the safety distance") {
  CHECK(obstacle_circle(at_m(3, 4), metres(1.5), metres(2)).radius == metres(3.5));
}

TEST_CASE("only circles that the segment enters are targets") {
  const FieldPoint a = at_m(0, 0), b = at_m(100, 0);
  CHECK(crosses(a, b, {at_m(50, 3.9), metres(4)}));
  CHECK_FALSE(crosses(a, b, {at_m(50, 4.1), metres(4)}));
  CHECK(crosses(a, b, {at_m(103.9, 0), metres(4)}));  // reaches over the end
  CHECK_FALSE(crosses(a, b, {at_m(104.1, 0), metres(4)}));
}

TEST_CASE("a circle tighter than the turn is replaced by one that touches it from inside") {
  // R = 4 on the axis, R_z = 5: radius 5, centre 1 m towards the side not passed.
  for (const Side side : {Side::left, Side::right}) {
    const Beside circle = replaced({metres(0), metres(4)}, metres(5), side);
    CHECK(circle.radius == metres(5));
    CHECK(circle.left.base() == Approx(-sign(side)));
  }
  CHECK(replaced({metres(2), metres(6)}, metres(5), Side::left).left == metres(2));
}

TEST_CASE("the detour around a replaced circle has its closed length") {
  // The circle above passed on the left: L_d = 1 on the other side. dx = sqrt(10^2 - (5 + 1)^2) =
  // 8, theta = arccos(6 / 10), L - b = 2 10 arccos 0.6 - 2 8.
  const DetourShape d = detour_shape({metres(0), metres(4)}, metres(5), Side::left);
  CHECK(d.reach.base() == Approx(8));
  CHECK(d.turn_rad == Approx(std::acos(0.6)));
  CHECK(d.extra.base() == Approx(20 * std::acos(0.6) - 16));
}

TEST_CASE("the detour around a circle on the axis has its closed length") {
  // R_z = 3, R = 5, L_d = 0: theta = arccos(3 / 8), L - b = 2 8 theta - 2 sqrt(64 - 9).
  const DetourShape d = detour_shape({metres(0), metres(5)}, metres(3), Side::right);
  CHECK(d.turn_rad == Approx(std::acos(3.0 / 8)));
  CHECK(d.extra.base() == Approx(16 * std::acos(3.0 / 8) - 2 * std::sqrt(55.0)));
}

TEST_CASE("passing on the side of the centre is longer than on the other") {
  // R_z = 3, R = 5, centre 2 m to the left. Left: arccos((3 - 2) / 8), dx = sqrt(64 - 1); right:
  // arccos((3 + 2) / 8), dx = sqrt(64 - 25).
  const Beside target{metres(2), metres(5)};
  const DetourShape left = detour_shape(target, metres(3), Side::left);
  const DetourShape right = detour_shape(target, metres(3), Side::right);
  CHECK(left.extra.base() == Approx(16 * std::acos(1.0 / 8) - 2 * std::sqrt(63.0)));
  CHECK(right.extra.base() == Approx(16 * std::acos(5.0 / 8) - 2 * std::sqrt(39.0)));
  CHECK(left.extra > right.extra);
}

TEST_CASE("a pass with several detours is as long as the sum says") {
  // b = 200 m; the three detours above: replaced, on the axis, and on the far side (N1 = 2 with the
  // centre opposite or on the axis, N2 = 1).
  const std::vector<DetourShape> detours{
      detour_shape({metres(0), metres(4)}, metres(5), Side::left),
      detour_shape({metres(0), metres(6)}, metres(5), Side::left),
      detour_shape({metres(2), metres(6)}, metres(5), Side::left)};
  const double extra_m = (20 * std::acos(0.6) - 16) +
                         (22 * std::acos(5.0 / 11) - 2 * std::sqrt(121.0 - 25)) +
                         (22 * std::acos(3.0 / 11) - 2 * std::sqrt(121.0 - 9));
  CHECK(pass_length(metres(200), detours).base() == Approx(200 + extra_m).epsilon(1e-12));
}

TEST_CASE("the taut curve around one circle is the detour of the formula") {
  Random random{11};
  for (int i = 0; i < 100; ++i) {
    const double turn_m = random.uniform(1, 6), radius_m = random.uniform(0.5, 8);
    // Deeper than a quarter turn no detour is flown; the other side is nearer then.
    const double left_m = random.uniform(-0.99, 0.6) * radius_m;
    const Side side = i % 2 == 0 ? Side::left : Side::right;
    const Beside target{metres(sign(side) * left_m), metres(radius_m)};
    const DetourShape shape = detour_shape(target, metres(turn_m), side);
    const auto curve = taut_curve({circle_for(target, 50, turn_m, side)}, turn_m);
    REQUIRE(curve);
    CHECK(curve->start.at.x == Approx(50 - shape.reach.base()));
    CHECK(length_m(*curve) == Approx((shape.extra + 2 * shape.reach).base()).margin(1e-6));
    const PathM fine = sampled(*curve, 1e-4 * turn_m);
    CHECK(length_m(fine) == Approx(length_m(*curve)).margin(1e-6));
    double nearest_m = INFINITY;
    for (const PointM p : fine) {
      nearest_m = std::min(nearest_m, norm(p - PointM{50, sign(side) * left_m}));
    }
    CHECK(nearest_m >= radius_m - 1e-6);
    CHECK(nearest_m <= radius_m + 1e-6);  // touches
  }
}

TEST_CASE("circles that overlap are passed along their hull") {
  // Two circles of 5 m, 6 m apart on the line, R_z = 3: theta = arccos(3/8) on either end, 6 m
  // straight between.
  const auto curve = taut_curve({{{50, 0}, 5, Side::left}, {{56, 0}, 5, Side::left}}, 3);
  REQUIRE(curve);
  CHECK(length_m(*curve) == Approx(16 * std::acos(3.0 / 8) + 6).margin(1e-9));
  CHECK(curve->start.at.x == Approx(50 - std::sqrt(55.0)));
  CHECK(end_pose(*curve).at.x == Approx(56 + std::sqrt(55.0)));
}

TEST_CASE("a circle in the lee of its neighbours does not bend the way") {
  const auto around = [](std::vector<PassedCircle> circles) {
    return length_m(*taut_curve(std::move(circles), 3));
  };
  const PassedCircle a{{50, 0}, 5, Side::left}, low{{55, -2}, 4, Side::left},
      b{{60, 0}, 5, Side::left};
  CHECK(around({a, low, b}) == Approx(around({a, b})).epsilon(1e-12));
}

TEST_CASE("circles passed on different sides are woven through") {
  // 13 m apart, so that the way crosses between them; both circles are touched, neither entered.
  const std::vector<PassedCircle> circles{{{50, -3}, 5, Side::left}, {{62, 3}, 5, Side::right}};
  const auto curve = taut_curve(circles, 3);
  REQUIRE(curve);
  for (const PassedCircle& c : circles) {
    double nearest_m = INFINITY;
    for (const PointM p : sampled(*curve, 1e-3))
      nearest_m = std::min(nearest_m, norm(p - c.center));
    CHECK(nearest_m == Approx(5).margin(1e-4));
  }
}

TEST_CASE("no way leads between circles that overlap") {
  CHECK_FALSE(taut_curve({{{50, -3}, 5, Side::left}, {{52, 3}, 5, Side::right}}, 3));
}
