#include "planner/avoidance/clear_way.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow::planner;

namespace {

Room open_with(std::vector<CircleM> circles) { return {std::move(circles), {}, {}}; }

}  // namespace

TEST_CASE("a clear way past one circle is little longer than the taut string") {
  const Room room = open_with({{{10, 0}, 3}});
  const auto way = clear_way({0, 0}, {20, 0}, room);
  REQUIRE(way);
  CHECK(room.is_free(*way));
  // Taut: two tangents of sqrt(100 - 9) = 9.54 m and an arc of 3 m through 2 asin(3 / 10): 20.91 m.
  CHECK(length_m(*way) >= 2 * std::sqrt(91.0) + 6 * std::asin(0.3));
  CHECK(length_m(*way) < 1.02 * 20.91);
}

TEST_CASE("a clear way finds the gap between circles, and none where they close one in") {
  const Room gap = open_with({{{10, -4}, 3.5}, {{10, 4}, 3.5}});
  const auto through = clear_way({0, 0}, {20, 0}, gap);
  REQUIRE(through);
  CHECK(length_m(*through) == Approx(20));
  std::vector<CircleM> ring;
  for (int i = 0; i < 12; ++i)
    ring.push_back({{8 * std::cos(i * M_PI / 6), 8 * std::sin(i * M_PI / 6)}, 3});
  CHECK_FALSE(clear_way({0, 0}, {20, 0}, open_with(ring)));
}

TEST_CASE("a clear way stays on the land") {
  const LandParts alley{{{{-1, -1}, {21, -1}, {21, 9}, {-1, 9}}, {}}};
  const Room room{{{{10, 0}, 3}}, {}, alley};
  const auto way = clear_way({0, 0}, {20, 0}, room);
  REQUIRE(way);
  for (const PointM p : *way) CHECK(p.y >= 0);
  const LandParts narrow{{{{-1, -1}, {21, -1}, {21, 2.9}, {-1, 2.9}}, {}}};
  CHECK_FALSE(clear_way({0, 0}, {20, 0}, Room{{{{10, 0}, 3}}, {}, narrow}));
}

TEST_CASE("a circle that holds an end of a way counts up to that end only") {
  const Room room = open_with({{{0, 2}, 2.1}, {{10, 0}, 3}});
  const auto way = clear_way({0, 0}, {20, 0}, room);
  REQUIRE(way);
  CHECK(distance_m({0, 2}, *way) >= 2 - 2e-3);
  CHECK(distance_m({10, 0}, *way) >= 3 - 1e-6);
}
