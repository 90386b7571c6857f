#include "planner/coverage/swath/inset.hpp"

#include <catch2/catch.hpp>

using namespace furrow;
using namespace furrow::planner;

namespace {

Ring square(double west, double south, double side) {
  return {at_m(west, south), at_m(west + side, south), at_m(west + side, south + side),
          at_m(west, south + side)};
}

Field plain(Ring boundary) { return {std::move(boundary), {}, {}}; }

double flight_m2(const Field& field, double margin_m, double buffer_m = 0) {
  const auto land = field_land(field, metres(margin_m), metres(buffer_m));
  REQUIRE(land);
  return area_m2(land->flight);
}

}  // namespace

TEST_CASE("a margin draws in the boundary and widens holes") {
  CHECK(flight_m2(plain(square(0, 0, 100)), 10) == Approx(80 * 80));
  const Field holed{square(0, 0, 100), {square(40, 40, 20)}, {}};
  // The hole of 20 m grows by the margin of 5 m and the buffer of 2 m to each side: 34 m.
  CHECK(flight_m2(holed, 5, 2) == Approx(90 * 90 - 34 * 34));
}

TEST_CASE("obstacles are kept from by the safety distance or by margin and buffer, the larger") {
  Field field = plain(square(0, 0, 100));
  field.holes = {square(10, 40, 20)};
  field.obstacles = {outlined("barn", square(60, 40, 20))};
  const auto left_m2 = [&](double margin_m, double buffer_m, double safety_m) {
    return area_m2(field_land(field, metres(margin_m), metres(buffer_m), metres(safety_m))->flight);
  };
  // The barn grows by 3 m to each side, the hole by nothing; then both by 1 + 4 m.
  CHECK(left_m2(0, 0, 3) == Approx(100 * 100 - 20 * 20 - 26 * 26));
  CHECK(left_m2(1, 4, 3) == Approx(98 * 98 - 30 * 30 - 30 * 30));
  const auto land = field_land(field, {}, {}, metres(3));
  CHECK(area_m2(land->land) == Approx(100 * 100 - 2 * 20 * 20));  // sprayed up to the walls
  CHECK(area_m2(land->taken) == Approx(20 * 20 + 26 * 26));
}

TEST_CASE("a margin splits a field at its neck and keeps both parts") {
  // Two squares of 40 m, joined by a neck 6 m wide.
  const Field field =
      plain({at_m(0, 0), at_m(40, 0), at_m(40, 17), at_m(60, 17), at_m(60, 0), at_m(100, 0),
             at_m(100, 40), at_m(60, 40), at_m(60, 23), at_m(40, 23), at_m(40, 40), at_m(0, 40)});
  const auto land = field_land(field, metres(4), {});
  REQUIRE(land);
  CHECK(land->flight.size() == 2);
  CHECK(area_m2(land->flight) == Approx(2 * 32 * 32));
}

TEST_CASE("a margin that leaves nothing is an error that says so") {
  const auto land = field_land(plain(square(0, 0, 10)), metres(5), {});
  REQUIRE(!land);
  CHECK(land.error().fault == PlanFault::margin_too_wide);
  CHECK(land.error().detail == "a margin of 5 m leaves nothing of a field of 100.0 m2");
}

TEST_CASE("repeated vertices and spikes without width are mended") {
  Ring ring = square(0, 0, 10);
  ring.insert(ring.begin() + 1, {at_m(5, 0), at_m(5, 0), at_m(5, 20), at_m(5, 0)});
  CHECK(flight_m2(plain(ring), 0) == Approx(100));
  std::reverse(ring.begin(), ring.end());
  CHECK(flight_m2(plain(ring), 0) == Approx(100));
}

TEST_CASE("a boundary that crosses itself is refused with the place") {
  const auto land =
      field_land(plain({at_m(1000, 0), at_m(1010, 10), at_m(1010, 0), at_m(1000, 10)}), {}, {});
  REQUIRE(!land);
  CHECK(land.error().fault == PlanFault::field_invalid);
  CHECK(land.error().detail == "boundary: Self-intersection at (1005.000, 5.000) m");
}

TEST_CASE("a hole that is no ring is named") {
  const auto land = field_land({square(0, 0, 10), {square(2, 2, 1), {at_m(5, 5)}}, {}}, {}, {});
  REQUIRE(!land);
  CHECK(land.error().detail == "hole 2: fewer than 3 vertices");
  const auto line =
      field_land({square(0, 0, 10), {{at_m(1, 1), at_m(2, 2), at_m(3, 3)}}, {}}, {}, {});
  REQUIRE(!line);
  CHECK(line.error().fault == PlanFault::field_invalid);
}

TEST_CASE("holes that touch, overlap or cross the boundary are taken out once") {
  // [2, 4] and [4, 6] touch, [5, 7] overlaps the second; one reaches 1 m over the eastern side.
  const Field field{
      square(0, 0, 10), {square(2, 2, 2), square(4, 2, 2), square(5, 2, 2), square(9, 5, 2)}, {}};
  CHECK(flight_m2(field, 0) == Approx(100 - 5 * 2 - 1 * 2));
}

TEST_CASE("a round obstacle is kept clear of on all sides") {
  const Field field{square(0, 0, 100), {}, {{"tree", at_m(50, 50), metres(10)}}};
  const auto land = field_land(field, {}, {});
  REQUIRE(land);
  REQUIRE(land->flight.size() == 1);
  for (const RingM& hole : land->flight[0].holes) {
    for (std::size_t i = 0; i < hole.size(); ++i) {
      const PointM middle = 0.5 * (hole[i] + hole[(i + 1) % hole.size()]) + land->origin;
      CHECK(norm(middle - PointM{50, 50}) >= 10 - 1e-6);
    }
  }
}
