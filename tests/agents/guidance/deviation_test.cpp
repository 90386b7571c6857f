#include "agents/guidance/deviation.hpp"

#include <catch2/catch.hpp>

namespace furrow::agents {
namespace {

TEST_CASE("deviation: is signed to the right of the flown direction", "[agents]") {
  CHECK(cross_track_m({1, 0}, {1, 10}, {1.5, 4}) == Approx(0.5));
  CHECK(cross_track_m({1, 10}, {1, 0}, {1.5, 4}) == Approx(-0.5));
  CHECK(cross_track_m({1, 1}, {1, 1}, {9, 9}) == 0.0);
}

TEST_CASE("deviation: follows an arc round either way", "[agents]") {
  for (const double side : {1.0, -1.0}) {
    const Segment arc{.start_m = 10.0,
                      .length_m = 3.0,
                      .from = {0, 0},
                      .ahead = {0, 1},
                      .curvature_per_m = side * 0.5,
                      .limit_mps = 1.0,
                      .entry_mps = 1.0};
    // 0.3 m outside of a circle of 2 m is to the left of a right turn.
    const Pose on = pose(arc, 11.5);
    const Deviation d = deviation(arc, on.at - (0.3 * side) * right_of(on.ahead));
    CHECK(d.along_m == Approx(11.5));
    CHECK(d.cross_m == Approx(-0.3 * side));
  }
}

}  // namespace
}  // namespace furrow::agents
