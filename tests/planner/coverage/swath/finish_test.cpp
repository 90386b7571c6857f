#include "planner/coverage/swath/swath.hpp"

#include "tests/planner/coverage/swath/swath_test_support.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow;
using namespace furrow::planner;

namespace {

Field rectangle(double wide_m, double high_m) {
  return {.boundary = {at_m(0, 0), at_m(wide_m, 0), at_m(wide_m, high_m), at_m(0, high_m)},
          .holes = {},
          .obstacles = {}};
}

}  // namespace

TEST_CASE("rows of a rectangle run along one of its edges, whatever its sides measure") {
  for (const auto& [wide_m, high_m] : {std::pair{137.0, 111.0}, {100.0, 100.0}, {61.3, 40.7}}) {
    const auto c = swath_coverage(rectangle(wide_m, high_m), metres(2), {});
    REQUIRE(c);
    INFO(wide_m << " x " << high_m << " m, rows at " << c->direction_deg);
    CHECK(std::fmod(c->direction_deg, 90) == Approx(0).margin(1e-6));
    CHECK(covered_share(*c) >= 0.999);
  }
}

TEST_CASE("a margin takes its own width from what is covered, and no more") {
  const auto c = swath_coverage(rectangle(200, 100), metres(2), {.margin = metres(3)});
  REQUIRE(c);
  // Flight keeps to 194 x 94 m; bands of 2 m reach 1 m beyond its sides and end where it ends:
  // between 194 x 94 and 196 x 96 m.
  CHECK(c->areas.covered.base() >= 194 * 94 * 0.999);
  CHECK(c->areas.covered.base() <= 196 * 96);
  CHECK(c->areas.outside.base() == Approx(0).margin(1e-6));
}
