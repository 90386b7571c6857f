#include "planner/avoidance/taut.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace furrow::planner {
namespace {

constexpr double turn_m = 3, kept_m = 3;

TEST_CASE(
    "taut: past a house the string is the same for any order of its corners, nearly upright "
    "or not",
    "[avoidance]") {
  // 7 m along the line, from 1 m on its right to 4 m on its left, walls up to 2 mm out of square.
  for (const double off_m : {0.0, 0.001, -0.001, 0.002}) {
    std::vector<PassedCircle> corners{{{40, -1}, kept_m, Side::left},
                                      {{47 + off_m, -1}, kept_m, Side::left},
                                      {{47, 4}, kept_m, Side::left},
                                      {{40 - off_m, 4 + off_m}, kept_m, Side::left}};
    // Only the two corners on the left are touched.
    const auto hull = taut_curve({corners[2], corners[3]}, turn_m);
    REQUIRE(hull);
    const auto before = [](const PassedCircle& a, const PassedCircle& b) {
      return std::pair{a.center.x, a.center.y} < std::pair{b.center.x, b.center.y};
    };
    std::sort(corners.begin(), corners.end(), before);
    do {
      const auto curve = taut_curve(corners, turn_m);
      REQUIRE(curve);
      CHECK(length_m(*curve) == Approx(length_m(*hull)).margin(1e-9));
    } while (std::next_permutation(corners.begin(), corners.end(), before));
  }
}

}  // namespace
}  // namespace furrow::planner
