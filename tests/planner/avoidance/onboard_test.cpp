#include "planner/avoidance/onboard.hpp"

#include "core/random.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow;
using namespace furrow::planner;

namespace {

OnboardLine north_from(double x_m, double y_m, double heading_rad = M_PI / 2) {
  return {{at_m(x_m, y_m), heading_rad}, at_m(0, 0), at_m(0, 100), metres(6)};
}

PathM plane(const std::vector<FieldPoint>& line) {
  PathM path;
  for (const FieldPoint p : line) path.push_back({p.x.base(), p.y.base()});
  return path;
}

}  // namespace

TEST_CASE("an aircraft on its line flies around an obstacle and is back on the line") {
  const Room room{{{{0.5, 50}, 3.5}}, {}, {}};
  const auto detour = onboard_detour(north_from(0, 10), room, metres(3));
  REQUIRE(detour);
  CHECK(detour->side == Side::left);  // the centre lies to the right
  CHECK(detour->way.front() == at_m(0, 10));
  CHECK(detour->way.back().x.base() == Approx(0).margin(1e-6));
  CHECK(room.is_free(plane(detour->way)));
}

TEST_CASE("a wide obstacle is flown around with the valve closed, one of about a swath is not") {
  // The line cuts a circle of 15 m in half: an open valve would spray two neighbours of 6 m again
  // all the way around, a closed one leaves what the turns cut off.
  const OnboardLine line = north_from(0, 0);
  const auto wide = onboard_detour(line, Room{{{{0.5, 50}, 15}}, {}, {}}, metres(3));
  REQUIRE(wide);
  CHECK_FALSE(wide->sprays);
  // It leaves the line sqrt((3 + 15)^2 - (3 + 0.5)^2) = 17.66 m before the centre: R_z, R and
  // R_z - L_d with the centre on the far side.
  CHECK(wide->way[wide->leaves].x.base() == Approx(0).margin(1e-6));
  CHECK(wide->way[wide->leaves].y.base() ==
        Approx(50 - std::sqrt(18 * 18 - 2.5 * 2.5)).margin(0.2));
  const auto slim = onboard_detour(line, Room{{{{0.5, 50}, 2.5}}, {}, {}}, metres(3));
  REQUIRE(slim);
  CHECK(slim->sprays);
  // Where area counts nothing, an open valve is as good as a closed one.
  const auto shortest =
      onboard_detour(line, Room{{{{0.5, 50}, 15}}, {}, {}}, metres(3), {.length = 1, .area = 0});
  REQUIRE(shortest);
  CHECK(shortest->length.base() <= wide->length.base() + 1e-9);
}

TEST_CASE("an aircraft beside its line joins it first") {
  const Room room{{{{0, 60}, 3.5}}, {}, {}};
  const auto detour = onboard_detour(north_from(0.4, 10, M_PI / 2 + 0.05), room, metres(3));
  REQUIRE(detour);
  CHECK(detour->way.front() == at_m(0.4, 10));
  CHECK(room.is_free(plane(detour->way)));
}

TEST_CASE("an obstacle too near for a turn is refused") {
  // R = 3.5, R_z = 3: the turn begins sqrt(6.5^2 - 3^2) = 5.8 m before the centre.
  const Room room{{{{0, 20}, 3.5}}, {}, {}};
  CHECK(onboard_detour(north_from(0, 14), room, metres(3)));
  const auto late = onboard_detour(north_from(0, 14.5), room, metres(3));
  REQUIRE_FALSE(late);
  CHECK(late.error() == NoDetour::too_late);
}

TEST_CASE("an obstacle in an alley that leaves no room is refused") {
  const Room wall{{{{0, 50}, 3.5}}, {}, {{{{-2, -10}, {2, -10}, {2, 110}, {-2, 110}}, {}}}};
  const auto closed = onboard_detour(north_from(0, 5), wall, metres(3));
  REQUIRE_FALSE(closed);
  CHECK(closed.error() == NoDetour::no_room);
}

TEST_CASE("a clear line needs no detour") {
  const Room room{{{{9, 50}, 3.5}}, {}, {}};
  const auto none = onboard_detour(north_from(0, 10), room, metres(3));
  REQUIRE_FALSE(none);
  CHECK(none.error() == NoDetour::nothing_ahead);
}

TEST_CASE("random detours on board are clear or refused") {
  Random random{21};
  int flown = 0, refused = 0;
  for (int i = 0; i < 1000; ++i) {
    std::vector<CircleM> circles{
        {{random.uniform(-3, 3), random.uniform(15, 90)}, random.uniform(2, 5)}};
    for (std::uint64_t k = random.below(8); k > 0; --k) {
      circles.push_back({{random.uniform(-20, 20), random.uniform(0, 100)}, random.uniform(2, 5)});
    }
    const Room room{circles, {}, {}};
    const OnboardLine line = north_from(random.uniform(-0.3, 0.3), 1, random.uniform(1.5, 1.64));
    const auto detour = onboard_detour(line, room, metres(3));
    if (!detour) {
      ++refused;
      continue;
    }
    ++flown;
    CHECK(room.is_free(plane(detour->way)));
  }
  CHECK(flown > 500);
  CHECK(refused > 0);
}
