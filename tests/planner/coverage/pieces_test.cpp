#include "planner/coverage/route.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

Piece piece(FieldPoint entry, FieldPoint exit) { return {{0, 2}, entry, entry, exit, exit}; }

TEST_CASE("route: pieces are apart where the way between them is longer than 10 m", "[planner]") {
  const Piece before = piece(at_m(0, 0), at_m(0, 50));
  Piece after = piece(at_m(9, 50), at_m(9, 0));
  CHECK_FALSE(are_apart(before, after));
  CHECK(are_apart(before, piece(at_m(11, 50), at_m(11, 0))));
  after.approach = {at_m(0, 52), at_m(9, 52)};  // 2 m + 9 m + 2 m
  CHECK(are_apart(before, after));
  CHECK_FALSE(are_apart(before, piece(at_m(90, 50), at_m(90, 50))));  // a place to visit
}

}  // namespace
}  // namespace furrow::planner
