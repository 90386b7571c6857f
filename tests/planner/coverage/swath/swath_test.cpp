#include "planner/coverage/swath/swath.hpp"

#include "tests/planner/coverage/swath/swath_test_support.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace furrow;
using namespace furrow::planner;

namespace {

const Field slanted{
    .boundary = {at_m(0, 0), at_m(700, 0), at_m(700, 100), at_m(40, 100), at_m(0, 60)},
    .holes = {},
    .obstacles = {}};
const Field corner{.boundary = {at_m(0, 0), at_m(300, 0), at_m(300, 80), at_m(80, 80),
                                at_m(80, 300), at_m(0, 300)},
                   .holes = {},
                   .obstacles = {}};

}  // namespace

TEST_CASE("a slanted corner shortens the rows that meet it") {
  const auto c = swath_coverage(slanted, metres(2), {.direction_deg = 90});
  REQUIRE(c);
  CHECK(c->strips.size() == 50);
  // 30 rows of 700 m below the slant; above it rows start at x = y - 60 for y = 61, 63 .. 99:
  // 20 x 700 - (1 + 3 + .. + 39) = 13 600. Together 34 600.
  CHECK(c->sprayed.base() == Approx(34'600).margin(1e-6));
  // Of 49 turns the 25 on the right side take 2 m; on the left 14 take 2 m, the one over the
  // slant's foot sqrt(1 + 4), and 9 along the slant sqrt(8): 105.69 m.
  CHECK(c->route.base() == Approx(34'600 + 78 + std::sqrt(5) + 9 * std::sqrt(8)).margin(1e-6));
  CHECK(outside_m(slanted, metres(2), *c) == 0);
  CHECK(covered_share(*c) >= 0.999);
}

TEST_CASE("an L is cut into two cells, each flown along its length") {
  const auto c = swath_coverage(corner, metres(2), {});
  REQUIRE(c);
  // 41 600 m2 at 2 m; two cells of 40 rows, so 2 x 39 turns of 2 m, joined at the corner.
  CHECK(c->sprayed.base() == Approx(20'800).margin(1e-6));
  CHECK(c->route.base() <= 20'957);
  CHECK(outside_m(corner, metres(2), *c) == 0);
  CHECK(covered_share(*c) >= 0.999);
}

TEST_CASE("a spike of any width costs no cover") {
  for (const double width_m : {0.0, 1e-9, 1e-4, 0.1}) {
    const Field spiked{
        .boundary = {at_m(0, 0), at_m(100, 0), at_m(100, 60), at_m(150, 60 + width_m),
                     at_m(100, 60 + width_m), at_m(100, 100), at_m(60, 100), at_m(60, 40),
                     at_m(30, 40), at_m(30, 100), at_m(0, 100)},
        .holes = {},
        .obstacles = {}};
    const auto c = swath_coverage(spiked, metres(2), {});
    REQUIRE(c);
    INFO("width " << width_m);
    CHECK(covered_share(*c) >= 0.999);
    CHECK(outside_m(spiked, metres(2), *c) == 0);
  }
}

TEST_CASE("a tremble at the end of a strip does not turn the boom") {
  const Field field{.boundary = {at_m(0, 0), at_m(100, 0), at_m(100, 10), at_m(0, 10)},
                    .holes = {},
                    .obstacles = {}};
  // Along y = 5 from end to end; before and after it, hovering, 2 cm to the side and back.
  const std::vector<FlownPlace> track{
      {at_m(0, 5), false},    {at_m(0, 5.02), true},   {at_m(0, 5), true},  {at_m(50, 5), true},
      {at_m(99.99, 5), true}, {at_m(100, 5.02), true}, {at_m(100, 5), true}};
  const auto flown = flown_coverage(field, metres(4), {track});
  REQUIRE(flown);
  CHECK(flown->areas.covered.base() == Approx(400));
  CHECK(flown->areas.outside.base() == Approx(0).margin(1e-6));
}

TEST_CASE("a track sprayed with a part of the boom covers as much as that part is wide") {
  const Field field{.boundary = {at_m(0, 0), at_m(100, 0), at_m(100, 10), at_m(0, 10)},
                    .holes = {},
                    .obstacles = {}};
  // 50 m of 4 m, then 50 m of 1.5 m.
  const std::vector<FlownPlace> track{
      {at_m(0, 5), false}, {at_m(50, 5), true}, {at_m(100, 5), true, metres(1.5)}};
  const auto flown = flown_coverage(field, metres(4), {track});
  REQUIRE(flown);
  CHECK(flown->areas.covered.base() == Approx(50 * 4 + 50 * 1.5));
  CHECK(flown->areas.repeated.base() == Approx(0).margin(1e-6));
}

TEST_CASE("what positions may err is kept from the edge where nothing outside may be sprayed") {
  const Field field{.boundary = {at_m(0, 0), at_m(100, 0), at_m(100, 10), at_m(0, 10)},
                    .holes = {},
                    .obstacles = {}};
  const auto c = swath_coverage(
      field, metres(2),
      {.edges = EdgeMode::stay_inside, .spray_margin = metres(0.1), .direction_deg = 90});
  REQUIRE(c);
  // 9.8 m across and 99.8 m along are left: five rows, the last shifted over the one before.
  CHECK(c->strips.size() == 5);
  CHECK(c->areas.covered.base() == Approx(99.8 * 9.8).margin(0.01));
  CHECK(c->areas.outside.base() == Approx(0).margin(1e-6));
}

TEST_CASE("rows that overlap cover the same land with more of them, and half the overlap beyond") {
  const Field field{.boundary = {at_m(0, 0), at_m(100, 0), at_m(100, 10), at_m(0, 10)},
                    .holes = {},
                    .obstacles = {}};
  // Rows 1.8 m apart: six, the last shifted over the one before; 0.1 m beyond both long edges.
  const auto all =
      swath_coverage(field, metres(2), {.row_overlap = metres(0.2), .direction_deg = 90});
  REQUIRE(all);
  CHECK(all->strips.size() == 6);
  for (const SwathStrip& strip : all->strips) CHECK(strip.width.base() == Approx(2));
  CHECK(all->areas.covered.base() == Approx(1000));
  CHECK(all->areas.outside.base() == Approx(20));
  CHECK(all->areas.repeated.base() == Approx(6 * 200 - 1020));

  const auto inside = swath_coverage(
      field, metres(2),
      {.edges = EdgeMode::stay_inside, .row_overlap = metres(0.2), .direction_deg = 90});
  REQUIRE(inside);
  CHECK(inside->areas.outside.base() == Approx(0).margin(1e-6));
  // What the inset by half the overlap takes from the ends of the rows.
  CHECK(inside->areas.missed.base() == Approx(2 * 0.1 * 10).margin(0.01));
}

TEST_CASE("overlap leaves a narrowed last row what is left and its overlap") {
  const Field field{.boundary = {at_m(0, 0), at_m(100, 0), at_m(100, 10), at_m(0, 10)},
                    .holes = {},
                    .obstacles = {}};
  const auto c = swath_coverage(
      field, metres(2),
      {.last_row = LastRow::narrowed, .row_overlap = metres(0.2), .direction_deg = 90});
  REQUIRE(c);
  // Five rows 1.8 m apart take 9 m; 1 m is left, 0.1 m more to both sides.
  REQUIRE(c->strips.size() == 6);
  const auto narrowest =
      std::min_element(c->strips.begin(), c->strips.end(),
                       [](const SwathStrip& a, const SwathStrip& b) { return a.width < b.width; });
  CHECK(narrowest->width.base() == Approx(1.2));
  CHECK(c->areas.covered.base() == Approx(1000));
  CHECK(c->areas.outside.base() == Approx(20));
}

TEST_CASE("rounds of a headland overlap as rows do") {
  const Field field{.boundary = {at_m(0, 0), at_m(100, 0), at_m(100, 60), at_m(0, 60)},
                    .holes = {},
                    .obstacles = {}};
  const auto c =
      swath_coverage(field, metres(2), {.row_overlap = metres(0.2), .headland_passes = 2});
  REQUIRE(c);
  // The middle of the outer round is half of 1.8 m inside; its band of 2 m begins 0.1 m outside.
  const auto outermost = std::min_element(
      c->strips.begin(), c->strips.end(),
      [](const SwathStrip& a, const SwathStrip& b) { return a.from.y < b.from.y; });
  CHECK(outermost->from.y.base() == Approx(0.9));
  CHECK(covered_share(*c) >= 0.999);
}

TEST_CASE("hundreds of rows leave no seam between them") {
  const Field field{.boundary = {at_m(0, 0), at_m(100, 0), at_m(100, 400), at_m(0, 400)},
                    .holes = {},
                    .obstacles = {}};
  const auto c = swath_coverage(field, metres(2), {.direction_deg = 90});
  REQUIRE(c);
  CHECK(c->strips.size() == 200);
  CHECK(c->areas.covered.base() == Approx(40'000).epsilon(1e-9));
  CHECK(c->areas.missed.base() == Approx(0).margin(1e-4));
  CHECK(c->areas.repeated.base() == Approx(0).margin(1e-4));
}

TEST_CASE("rows of unlike length that overlap are counted once where they do") {
  const Field field{.boundary = {at_m(-10, -10), at_m(30, -10), at_m(30, 10), at_m(-10, 10)},
                    .holes = {},
                    .obstacles = {}};
  // 10 m along y = 0 and, shifted by 2 m, along y = 3.6, each 4 m wide: 8 m x 0.4 m twice.
  const auto flown = flown_coverage(
      field, metres(4),
      {{{at_m(0, 0), false}, {at_m(10, 0), true}}, {{at_m(2, 3.6), false}, {at_m(12, 3.6), true}}});
  REQUIRE(flown);
  CHECK(flown->areas.covered.base() == Approx(80 - 3.2));
  CHECK(flown->areas.repeated.base() == Approx(3.2));
}
