#include "core/field.hpp"

#include <catch2/catch.hpp>

namespace furrow {
namespace {

// 10 x 10 m with a notch of 4 x 6 m cut from the middle of its top.
const Ring notched{at_m(0, 0), at_m(10, 0), at_m(10, 10), at_m(7, 10),
                   at_m(7, 4), at_m(3, 4),  at_m(3, 10),  at_m(0, 10)};

TEST_CASE("ring: contains what lies inside, not what lies in its notch", "[core]") {
  CHECK(contains(notched, at_m(5, 2)));
  CHECK(contains(notched, at_m(1, 9)));
  CHECK(contains(notched, at_m(9, 9)));
  CHECK_FALSE(contains(notched, at_m(5, 7)));
  CHECK_FALSE(contains(notched, at_m(-1, 5)));
  CHECK_FALSE(contains(notched, at_m(5, 11)));
}

TEST_CASE("ring: contains the same points whichever way round it goes", "[core]") {
  const Ring reversed(notched.rbegin(), notched.rend());
  for (double x = -0.5; x < 11.0; x += 1.0) {
    for (double y = -0.5; y < 11.0; y += 1.0) {
      CHECK(contains(reversed, at_m(x, y)) == contains(notched, at_m(x, y)));
    }
  }
}

TEST_CASE("ring: the distance to its edges is the same from inside and outside", "[core]") {
  CHECK(edge_distance(notched, at_m(5, 3)).base() == Approx(1.0));
  CHECK(edge_distance(notched, at_m(5, 5)).base() == Approx(1.0));
  CHECK(edge_distance(notched, at_m(13, 14)).base() == Approx(5.0));  // 3, 4 from a corner
}

TEST_CASE("obstacle: its depth is measured from its edge, round or outlined", "[core]") {
  const Obstacle tree{"tree", at_m(10, 0), metres(3)};
  CHECK(depth_in(tree, at_m(11, 0)).base() == Approx(2));
  CHECK(depth_in(tree, at_m(15, 0)).base() == Approx(-2));
  const Obstacle house = outlined("house", {at_m(0, 0), at_m(8, 0), at_m(8, 6), at_m(0, 6)});
  CHECK(house.center == at_m(4, 3));
  CHECK(house.radius.base() == Approx(5));  // half the diagonal of 6 by 8
  CHECK(depth_in(house, at_m(4, 1)).base() == Approx(1));
  CHECK(depth_in(house, at_m(4, -2)).base() == Approx(-2));
}

}  // namespace
}  // namespace furrow
