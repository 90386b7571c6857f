#include "mission/polygon.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace furrow::mission {
namespace {

const Ring square{at_m(0, 0), at_m(10, 0), at_m(10, 10), at_m(0, 10)};

TEST_CASE("polygon: sound outlines are sound in both orientations", "[mission]") {
  Ring clockwise{square.rbegin(), square.rend()};
  const Ring notched{at_m(0, 0), at_m(10, 0), at_m(10, 10), at_m(5, 1), at_m(0, 10)};

  CHECK_FALSE(ring_fault(square));
  CHECK_FALSE(ring_fault(clockwise));
  CHECK_FALSE(ring_fault(notched));
  CHECK(area(clockwise) == square_metres(100));
  CHECK(area(notched) == square_metres(55));  // The square without 10 * 9 / 2.
}

TEST_CASE("polygon: a vertex on another edge is a fault", "[mission]") {
  const Ring pinched{at_m(0, 0), at_m(10, 0), at_m(10, 10), at_m(5, 0), at_m(0, 10)};

  CHECK(ring_fault(pinched) ==
        "must not cross or touch itself: edge (0, 0)-(10, 0) meets edge (5, 0)-(0, 10)");
}

TEST_CASE("polygon: an outline of 10 000 vertices is judged", "[mission]") {
  Ring circle;
  for (int i = 0; i < 10'000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 10'000;
    circle.push_back(at_m(500 * std::cos(angle), 500 * std::sin(angle)));
  }

  CHECK_FALSE(ring_fault(circle));
  std::swap(circle[5'000], circle[5'001]);
  CHECK(ring_fault(circle));
}

TEST_CASE("polygon: a point is inside, on the edge or outside", "[mission]") {
  CHECK(is_inside(at_m(5, 5), square));
  CHECK_FALSE(is_inside(at_m(10, 5), square));
  CHECK_FALSE(is_inside(at_m(0, 0), square));
  CHECK_FALSE(is_inside(at_m(11, 5), square));
  CHECK_FALSE(is_inside(at_m(-1, 10), square));
  CHECK(distance(at_m(5, 5), square) == metres(0));
  CHECK(distance(at_m(13, 14), square) == metres(5));  // 3-4-5 from the corner.
  CHECK(distance(at_m(5, -2), square) == metres(2));
}

}  // namespace
}  // namespace furrow::mission
