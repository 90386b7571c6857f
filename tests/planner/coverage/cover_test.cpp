#include "planner/coverage/led_or_ended.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow;
using namespace furrow::planner;

namespace {

Field land(std::vector<Obstacle> obstacles) {
  return {{at_m(0, 0), at_m(84, 0), at_m(84, 150), at_m(0, 150)}, {}, std::move(obstacles)};
}

SwathSettings rows_north() {
  SwathSettings s;
  s.direction_deg = 0;
  s.avoidance.emplace();
  s.avoidance->safety = metres(1.5);
  s.avoidance->turn_radius = metres(3);
  return s;
}

Obstacle block(const char* id, double x, double y, double width_m, double depth_m) {
  return outlined(
      id, {at_m(x, y), at_m(x + width_m, y), at_m(x + width_m, y + depth_m), at_m(x, y + depth_m)});
}

// As all outlines that a circle of two swaths does not hold did before there was a choice.
double cost_where_rows_end_m(const Field& field) {
  SwathSettings s = rows_north();
  s.safety = s.avoidance->safety;
  s.avoidance.reset();
  const auto made = cover(field, metres(6), s);
  REQUIRE(made);
  return coverage_cost_m(*made, metres(6), AvoidanceSettings{}, metres(5));
}

// Of rows and the ways between them from outlines, sampled.
double nearest_m(const Route& route, const Field& field) {
  double least = INFINITY;
  std::vector<FieldPoint> way;
  for (const Strip& strip : route.strips) {
    way.insert(way.end(), strip.approach.begin(), strip.approach.end());
    way.insert(way.end(), {strip.begin, strip.end});
  }
  for (std::size_t i = 1; i < way.size(); ++i) {
    const FieldVector leg = way[i] - way[i - 1];
    for (int k = 0; k <= 200; ++k) {
      const FieldPoint at = way[i - 1] + FieldVector{0.005 * k * leg.x, 0.005 * k * leg.y};
      for (const Obstacle& o : field.obstacles) least = std::min(least, -depth_in(o, at).base());
    }
  }
  return least;
}

}  // namespace

TEST_CASE("the cost of a coverage is its way, its corners and the ground missed or repeated") {
  const Field field{{at_m(0, 0), at_m(12, 0), at_m(12, 100), at_m(0, 100)}, {}, {}};
  const auto rows = cover(field, metres(6), rows_north());
  REQUIRE(rows);
  // Two rows of 100 m, 6 m between them and two corners of 2.5 m, half of it: 105.5 m.
  AvoidanceSettings weights;
  CHECK(coverage_cost_m(*rows, metres(6), weights, metres(5)) == Approx(105.5).margin(1e-3));
  // A turn of 25 m counts 20 m more.
  CHECK(coverage_cost_m(*rows, metres(6), weights, metres(25)) == Approx(115.5).margin(1e-3));
  // 60 m2 more that are repeated are 10 m of a swath of 6 m.
  Coverage repeating = *rows;
  repeating.sweep->areas.repeated += square_metres(60);
  weights.length_weight = 0;
  weights.area_weight = 1;
  CHECK(coverage_cost_m(repeating, metres(6), weights, metres(5)) == Approx(10).margin(1e-3));
}

TEST_CASE("rows are led around a hedge along them, which costs less than to end them there") {
  // 2 x 60 m in the edge of the row at x = 33, which must keep 1.6 m from it: 0.6 m aside for 60 m,
  // and where it turns off and back its boom passes at most a metre of the swath twice. Ended, the
  // row becomes two and a third beside the hedge, which overlaps its neighbour.
  const Field field = land({block("hedge", 30, 50, 2, 60)});
  const auto made = cover(field, metres(6), rows_north());
  REQUIRE(made);
  CHECK(made->sweep->avoidance->ended == 0);
  CHECK(made->sweep->avoidance->planned.detours == 1);
  const double wrong_m2 = (made->sweep->areas.missed + made->sweep->areas.repeated).base();
  CHECK(wrong_m2 >= 0.6 * 60);
  CHECK(wrong_m2 <= 0.6 * 60 + 2 * 6);
  // 14 rows of 150 m, 13 ways of 6 m and 26 corners; the detour adds less than a metre.
  const double straight_m = 14 * 150 + 13 * 6 + 26 * 2.5;
  const double cost_m = coverage_cost_m(*made, metres(6), AvoidanceSettings{}, metres(5));
  CHECK(cost_m > (straight_m + wrong_m2 / 6) / 2);
  CHECK(cost_m < (straight_m + 1 + wrong_m2 / 6) / 2);
  CHECK(cost_m < cost_where_rows_end_m(field));
}

TEST_CASE("rows end at a barn, which costs less than to lead them around it") {
  // 30 x 30 m across five rows, 0, 6 and 12 m from its middle. Around it, 1.6 m off, they are at
  // least 2 (16.6 + 2 10.6 + 2 4.6) = 94 m longer in all, less what arcs spare, as they were before
  // they left 33.2 m each unsprayed. Ended they need not fly those 166 m, but five more turns of 6
  // m and 5 m for their corners, and two ways past the barn, half around it each: 55 + 2 66 m.
  const Field field = land({block("barn", 30, 50, 30, 30)});
  const auto made = cover(field, metres(6), rows_north());
  REQUIRE(made);
  CHECK(made->sweep->avoidance->ended == 1);
  CHECK(made->sweep->avoidance->planned.targets == 0);
  const double straight_m = 14 * 150 + 13 * 6 + 26 * 2.5;
  const double wrong_m = (made->sweep->areas.missed + made->sweep->areas.repeated).base() / 6;
  const double cost_m = coverage_cost_m(*made, metres(6), AvoidanceSettings{}, metres(5));
  CHECK(cost_m < (straight_m - 166 + 55 + 2 * 66.5 + wrong_m) / 2);
  CHECK(cost_m == Approx(cost_where_rows_end_m(field)));
}

TEST_CASE("of two outlines each is judged by itself") {
  const Field field = land({block("barn", 30, 40, 30, 30), block("hedge", 66, 50, 2, 60)});
  const auto made = cover(field, metres(6), rows_north());
  REQUIRE(made);
  CHECK(made->sweep->avoidance->ended == 1);
  CHECK(made->sweep->avoidance->planned.targets == 1);
}

TEST_CASE("a walk on a grid ends or is led around outlines by the same cost") {
  CoverageSettings grid;
  grid.avoidance = rows_north().avoidance;
  const auto hedge = cover(land({block("hedge", 30, 50, 2, 60)}), metres(6), grid);
  const auto barn = cover(land({block("barn", 30, 48, 30, 30)}), metres(6), grid);
  REQUIRE(hedge);
  REQUIRE(barn);
  CHECK(hedge->sweep->avoidance->ended == 0);
  CHECK(barn->sweep->avoidance->ended == 1);
}

TEST_CASE("half circles go around the circles that hold outlines, and rows end where none fits") {
  SwathSettings classic = rows_north();
  classic.avoidance->method = AvoidanceMethod::classic;
  // A wall of 2 x 20 m, held by a circle of 10.05 m: those around it fit the field. One of 4 x 60
  // m, of 30.07 m, is too near to the edge on the left of its row.
  for (const Field& field :
       {land({block("wall", 44, 60, 2, 20)}), land({block("hedge", 62, 45, 4, 60)})}) {
    const auto made = cover(field, metres(6), classic);
    REQUIRE(made);
    const AvoidanceRecord& record = *made->sweep->avoidance;
    CHECK(record.ended == 0);
    CHECK(record.planned.detours + record.planned.blocked == record.planned.crowds);
    CHECK(record.planned.crowds > 0);
    CHECK((record.planned.blocked > 0) == (field.obstacles.front().id == "hedge"));
    CHECK(record.classic.missed == record.planned.missed);
    CHECK(nearest_m(made->route, field) > 1.5);
  }
}
