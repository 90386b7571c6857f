#include "planner/coverage/route.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

Piece piece(FieldPoint entry, FieldPoint exit) { return {{0, 2}, entry, entry, exit, exit}; }

TEST_CASE("route: pieces are apart where the way between them is longer than 10 m", "[planner]") {
  constexpr Length swath = metres(8);
  const Piece before = piece(at_m(0, 0), at_m(0, 50));
  Piece after = piece(at_m(9, 50), at_m(9, 0));
  CHECK_FALSE(are_apart(before, after, swath));
  CHECK(are_apart(before, piece(at_m(11, 50), at_m(11, 0)), swath));
  after.approach = {at_m(0, 52), at_m(9, 52)};  // 2 m + 9 m + 2 m
  CHECK(are_apart(before, after, swath));
  CHECK_FALSE(are_apart(before, piece(at_m(90, 50), at_m(90, 50)), swath));  // a place to visit
}

TEST_CASE("route: pieces are apart where the way leads past the end of a row between",
          "[planner]") {
  // Rows of 4 m: one and a half of them are 6 m aside. How far along the row counts not.
  const Piece before = piece(at_m(0, 0), at_m(0, 50));
  CHECK_FALSE(are_apart(before, piece(at_m(5.9, 57), at_m(5.9, 0)), metres(4)));
  CHECK(are_apart(before, piece(at_m(6.1, 50), at_m(6.1, 0)), metres(4)));
  Piece after = piece(at_m(4, 50), at_m(4, 0));
  after.approach = {at_m(6.1, 51)};
  CHECK(are_apart(before, after, metres(4)));
}

}  // namespace
}  // namespace furrow::planner
