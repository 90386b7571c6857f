#include "planner/coverage/swath/swath.hpp"
#include "tests/planner/coverage/swath/swath_test_support.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

using namespace furrow;
using namespace furrow::planner;

namespace {

struct Named {
  std::string name;
  Field field;
};

Field plain(Ring boundary) { return {std::move(boundary), {}, {}}; }

Field comb() {
  Ring ring{at_m(0, 0), at_m(210, 0)};
  for (int tooth = 5; tooth >= 0; --tooth) {
    const double west = 40.0 * tooth;
    ring.push_back(at_m(west + 11, 120));
    ring.push_back(at_m(west, 120));
    if (tooth > 0) ring.push_back(at_m(west, 30)), ring.push_back(at_m(west - 29, 30));
  }
  ring[1] = at_m(211, 0);
  return plain(ring);
}

Ring circle(double radius_m, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back(at_m(radius_m * std::cos(angle), radius_m * std::sin(angle)));
  }
  return ring;
}

Field river_bend(int corners) {
  Field field;
  const auto bank = [&](int i, double wide_m) {
    return at_m(600.0 * i / corners, 90 * std::sin(2 * std::numbers::pi * i / corners) + wide_m);
  };
  for (int i = 0; i <= corners; ++i) field.boundary.push_back(bank(i, 0));
  for (int i = corners; i >= 0; --i) field.boundary.push_back(bank(i, 80));
  return field;
}

std::vector<Named> handmade() {
  return {
      {"u", plain({at_m(0, 0), at_m(150, 0), at_m(150, 130), at_m(103, 130), at_m(103, 41),
                   at_m(47, 41), at_m(47, 130), at_m(0, 130)})},
      {"comb", comb()},
      {"ring", {circle(90, 120), {circle(40, 60)}, {}}},
      {"river bend", river_bend(150)},
      {"garden of 0.1 ha", plain({at_m(0, 0), at_m(38, 4), at_m(30, 31), at_m(11, 36)})},
      {"triangle", plain({at_m(0, 0), at_m(200, 0), at_m(20, 90)})},
      {"orchard with trees",
       {{at_m(0, 0), at_m(120, 0), at_m(120, 90), at_m(0, 90)},
        {},
        {{"a", at_m(30, 30), metres(4)},
         {"b", at_m(60, 50), metres(3)},
         {"c", at_m(90, 20), metres(5)}}}},
  };
}

}  // namespace

TEST_CASE("hand-made fields of every shape are covered without leaving them") {
  for (const auto& [name, field] : handmade()) {
    for (const double swath_m : {2.0, 3.0}) {
      INFO(name << ", swath " << swath_m << " m");
      const auto c = swath_coverage(field, metres(swath_m), {});
      REQUIRE(c);
      CHECK(covered_share(*c) >= 0.999);
      CHECK(outside_m(field, metres(swath_m), *c) == 0);
      CHECK(c->route >= c->order_bound - metres(1e-6));
      const auto inside = swath_coverage(field, metres(swath_m), {.edges = EdgeMode::stay_inside});
      REQUIRE(inside);
      CHECK(inside->areas.outside.base() <= 1e-3);
      CHECK(outside_m(field, metres(swath_m), *inside) == 0);
    }
  }
}

TEST_CASE("parts that a margin parts are covered one after another, each with a fresh start") {
  const Field neck =
      plain({at_m(0, 0), at_m(40, 0), at_m(40, 17), at_m(60, 17), at_m(60, 0), at_m(100, 0),
             at_m(100, 40), at_m(60, 40), at_m(60, 23), at_m(40, 23), at_m(40, 40), at_m(0, 40)});
  const auto c = swath_coverage(neck, metres(2), {.margin = metres(4), .near = at_m(200, 20)});
  REQUIRE(c);
  CHECK(c->parts == 2);
  int starts = 0;
  for (const SwathStrip& strip : c->strips) starts += strip.approach.empty() ? 1 : 0;
  CHECK(starts == 2);
  CHECK(c->strips.front().from.x.base() > 60);  // the part nearer to the supply comes first
}

TEST_CASE("headland rounds turn as told and leave the rows what lies inside them") {
  const Field field = plain({at_m(0, 0), at_m(100, 0), at_m(100, 60), at_m(0, 60)});
  SwathSettings settings{.direction_deg = 90, .headland_passes = 2};
  const auto c = swath_coverage(field, metres(2), settings);
  REQUIRE(c);
  // Rounds 1 and 3 m from the edge: 2 (98 + 58) + 2 (94 + 54) m. Inside 92 x 52 m: 26 rows of 92 m.
  CHECK(c->sprayed.base() == Approx(312 + 296 + 26 * 92));
  CHECK(covered_share(*c) >= 0.999);
  // Left out is what the round end of a turn does not reach at the corners of both rounds, and a
  // little of the arcs, which are drawn as polygons.
  CHECK(c->areas.missed.base() <= 8 * (1 - std::numbers::pi / 4) + 0.1);

  const auto area_of_round = [](const SwathCoverage& coverage) {
    double twice = 0;
    for (std::size_t i = 0; i < coverage.strips.size(); ++i) {
      const SwathStrip& s = coverage.strips[i];
      if (s.from.y == s.to.y && s.from.y != metres(1) && s.from.y != metres(59)) continue;
      twice += (s.from.x * s.to.y - s.to.x * s.from.y).base();
    }
    return twice / 2;
  };
  settings.headland_turn = HeadlandTurn::clockwise;
  const auto back = swath_coverage(field, metres(2), settings);
  REQUIRE(back);
  CHECK(area_of_round(*c) > 0);
  CHECK(area_of_round(*back) < 0);
}

TEST_CASE("flown tracks are judged by where the valve was open") {
  const Field field = plain({at_m(0, 0), at_m(100, 0), at_m(100, 10), at_m(0, 10)});
  // One pass of 4 m width along y = 2 from 20 m before the field, open from x = -10 to 60 and
  // again over the last 20 m in the other direction.
  const std::vector<FlownPlace> track{{at_m(-20, 2), false},
                                      {at_m(-10, 2), false},
                                      {at_m(60, 2), true},
                                      {at_m(60, 2), false},
                                      {at_m(40, 2), true}};
  const auto flown = flown_coverage(field, metres(4), {track});
  REQUIRE(flown);
  CHECK(flown->areas.covered.base() == Approx(60 * 4));
  CHECK(flown->areas.outside.base() == Approx(10 * 4));
  CHECK(flown->areas.missed.base() == Approx(1000 - 240));
  CHECK(flown->areas.repeated.base() == Approx(20 * 4).margin(15));
  CHECK(flown->outside.base() == Approx(20).margin(1e-5));
}

TEST_CASE("ground left out all around a house gets strips along its sides") {
  // Rows of 4 m along y keep 1 m from a barn of 24 x 14 m in 3.5 ha. Above, below and beside it
  // they leave out 0.3 % of the land, in one place that goes round it.
  const Field field{.boundary = {at_m(0, 0), at_m(220, 0), at_m(220, 160), at_m(0, 160)},
                    .holes = {{at_m(181, 120), at_m(205, 120), at_m(205, 134), at_m(181, 134)}},
                    .obstacles = {}};
  const auto c = swath_coverage(field, metres(4), {.hole_buffer = metres(1), .direction_deg = 0});
  REQUIRE(c);
  CHECK(covered_share(*c) >= 0.9995);
  CHECK(outside_m(field, metres(4), *c) == 0);
}
