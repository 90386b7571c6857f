#include "agents/guidance/path.hpp"

#include <catch2/catch.hpp>
#include <numbers>

namespace furrow::agents {
namespace {

// A U-turn between two strips 2 m apart, cut by 1 m at each corner.
Path u_turn() {
  Path path{{1.0, 0.0}, {.acceleration_mps2 = 3.0, .corner_cut_m = 1.0, .min_radius_m = 0.0}};
  path.add({1.0, 100.0}, 3.0);
  path.add({3.0, 100.0}, 3.0);
  path.add({3.0, 0.0}, 3.0);
  path.finish();
  return path;
}

TEST_CASE("path: two corners of a narrow turn become one half circle", "[agents]") {
  // 99 m, half a circle of radius 1 m, 99 m.
  CHECK(u_turn().length_m() == Approx(198.0 + std::numbers::pi));
}

TEST_CASE("path: is continuous in place and direction", "[agents]") {
  const Path path = u_turn();
  for (std::size_t i = 0; i + 1 < path.segments().size(); ++i) {
    const Pose end = pose(path.segments()[i], path.segments()[i].end_m());
    const Segment& next = path.segments()[i + 1];
    CHECK(norm(end.at - next.from) == Approx(0.0).margin(1e-9));
    CHECK(dot(end.ahead, next.ahead) == Approx(1.0));
  }
}

TEST_CASE("path: arcs are no faster than the sideways acceleration allows", "[agents]") {
  const Path path = u_turn();
  for (const Segment& s : path.segments()) {
    if (!s.is_straight()) CHECK(s.limit_mps == Approx(std::sqrt(0.9 * 3.0 * 1.0)));
  }
}

TEST_CASE("path: a corner lies at the middle of its arc, a strip keeps its distances", "[agents]") {
  const Path path = u_turn();
  CHECK(path.along_m(50.0) == Approx(50.0));
  CHECK(path.along_m(100.0) == Approx(99.0 + 0.25 * std::numbers::pi));
  CHECK(path.along_m(202.0) == Approx(path.length_m()));
}

TEST_CASE("path: an about-turn is made at a stop", "[agents]") {
  Path path{{0.0, 0.0}, {.acceleration_mps2 = 2.0, .corner_cut_m = 1.0, .min_radius_m = 0.0}};
  path.add({0.0, 4.0}, 10.0);
  path.add({0.0, 0.0}, 10.0);
  path.finish();
  // Twice 4 m from rest to rest at 2 m/s2: 2 * 2 * sqrt(4 / 2) s.
  CHECK(path.duration_s() == Approx(4.0 * std::sqrt(2.0)));
}

TEST_CASE("path: corners tighter than the least turn radius are turned at a stop", "[agents]") {
  Path path{{0.0, 0.0}, {.acceleration_mps2 = 2.0, .corner_cut_m = 1.0, .min_radius_m = 5.0}};
  path.add({0.0, 4.0}, 10.0);
  path.add({4.0, 4.0}, 10.0);
  path.finish();
  CHECK(path.length_m() == Approx(8.0));
  CHECK(path.duration_s() == Approx(4.0 * std::sqrt(2.0)));
}

TEST_CASE("path: time is distance over speed and the ramps", "[agents]") {
  Path path{{0.0, 0.0}, {.acceleration_mps2 = 2.0, .corner_cut_m = 0.0, .min_radius_m = 0.0}};
  path.add({0.0, 60.0}, 6.0);
  path.finish();
  CHECK(path.duration_s() == Approx(60.0 / 6.0 + 6.0 / 2.0));
}

}  // namespace
}  // namespace furrow::agents
