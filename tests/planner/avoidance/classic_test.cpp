#include "planner/avoidance/classic.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow;
using namespace furrow::planner;

namespace {

double extra_m(PointM center, ClassicSide side) {
  const PassM pass{{0, 0}, {100, 0}, 6};
  const Room room{{{center, 4}}, {}, {}};
  return length_m(classic_path(pass, targets_of(pass, room), side)) - 100;
}

}  // namespace

TEST_CASE("a half circle is pi / 2 times as long as its diameter") {
  // On the axis: radius 4. Centre 1 m to the left, passed on the left: radius 5; on the right the
  // circle crosses the line at sqrt(16 - 1). Legs of 3 degrees fall short by 1e-4.
  const auto extra_of = [](double radius_m) { return radius_m * (M_PI - 2); };
  CHECK(extra_m({50, 0}, ClassicSide::left) == Approx(extra_of(4)).epsilon(1e-3));
  CHECK(extra_m({50, 1}, ClassicSide::left) == Approx(extra_of(5)).epsilon(1e-3));
  CHECK(extra_m({50, 1}, ClassicSide::nearer) == Approx(extra_of(std::sqrt(15))).epsilon(1e-3));
}

TEST_CASE("half circles that meet are flown as one") {
  const PassM pass{{0, 0}, {100, 0}, 6};
  const Room room{{{{50, 0}, 4}, {{56, 0}, 4}}, {}, {}};
  const PathM path = classic_path(pass, targets_of(pass, room), ClassicSide::left);
  // From 46 to 60: one half circle of 7 m.
  CHECK(length_m(path) - 100 == Approx(7 * (M_PI - 2)).epsilon(1e-3));
}
