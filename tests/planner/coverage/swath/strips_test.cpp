#include "planner/coverage/swath/strips.hpp"
#include "planner/coverage/swath/groups.hpp"

#include <catch2/catch.hpp>

using namespace furrow::planner;

namespace {

const LandPart square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}};

double total_m(const Sweep& rows) {
  double sum = 0;
  for (const Chord& chord : rows.chords) sum += chord.length_m();
  return sum;
}

}  // namespace

TEST_CASE("rows begin half a swath from the edge and lie one swath apart") {
  const Sweep rows = sweep(square, {square}, {1, 0}, {.swath_m = 2, .edge_gap_m = 1});
  REQUIRE(rows.rows.size() == 5);
  CHECK(rows.rows.front().v_m == 1);
  CHECK(rows.rows.back().v_m == 9);
  CHECK(total_m(rows) == Approx(50));
}

TEST_CASE("a remainder shifts the last row against the edge or narrows it") {
  SweepRule rule{.swath_m = 4, .edge_gap_m = 2};
  const Sweep shifted = sweep(square, {square}, {1, 0}, rule);
  REQUIRE(shifted.rows.size() == 3);  // at 2, 6 and, for the last 2 m, against the edge
  CHECK(shifted.rows.back().v_m == Approx(8));
  CHECK(shifted.rows.back().half_width_m == 2);
  rule.last_row = LastRow::narrowed;
  const Sweep narrowed = sweep(square, {square}, {1, 0}, rule);
  CHECK(narrowed.rows.back().v_m == Approx(9));
  CHECK(narrowed.rows.back().half_width_m == Approx(1));
}

TEST_CASE("lines exactly through vertices and along edges still pair") {
  // Teeth whose tips and whose gap's floor lie exactly on rows at 1, 3 and 5.
  const LandPart teeth{{{0, 0}, {9, 0}, {9, 5}, {6, 5}, {6, 3}, {3, 3}, {1.5, 5}, {0, 3}}, {}};
  const Sweep rows = sweep(teeth, {teeth}, {1, 0}, {.swath_m = 2, .edge_gap_m = 1});
  for (const Chord& chord : rows.chords) {
    CHECK(chord.low_m >= 0);
    CHECK(chord.high_m <= 9);
    CHECK(chord.low_m < chord.high_m);
  }
  // At y = 3 the line runs along the floor, with the land above: [0, 3] under the tip, [6, 9].
  CHECK(rows.chords[1].high_m == 3);
  CHECK(rows.chords[2].low_m == 6);
}

TEST_CASE("a hole splits the rows that meet it and no others") {
  const LandPart holed{square.outer, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}};
  const Sweep rows = sweep(holed, {holed}, {1, 0}, {.swath_m = 2, .edge_gap_m = 1});
  CHECK(rows.chords.size() == 6);
  // Below, left and right of the hole, and above.
  CHECK(strip_groups(rows, 2).size() == 4);
}

TEST_CASE("inside rows end where their whole width still fits") {
  const LandPart triangle{{{0, 0}, {20, 0}, {0, 20}}, {}};
  SweepRule rule{.swath_m = 2, .edge_gap_m = 1, .edges = EdgeMode::stay_inside};
  const Sweep rows = sweep(triangle, {triangle}, {1, 0}, rule);
  // The slant x = 20 - y meets the top of the first row at y = 2.
  CHECK(rows.chords.front().high_m == Approx(18));
}

TEST_CASE("strips below the least length are dropped at the price of their area") {
  const LandPart triangle{{{0, 0}, {20, 0}, {0, 20}}, {}};
  const Sweep rows =
      sweep(triangle, {triangle}, {1, 0}, {.swath_m = 2, .edge_gap_m = 1, .min_strip_m = 4});
  // Rows at y = 1, 3 .. 19 are 20 - y long: those of 3 and 1 m are dropped, 2 m wide.
  CHECK(rows.chords.size() == 8);
  CHECK(rows.dropped_m2 == Approx(8));
}
