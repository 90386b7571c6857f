#include "planner/avoidance/areas.hpp"

#include "planner/avoidance/crowd.hpp"
#include "planner/avoidance/field_options.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow;
using namespace furrow::planner;

namespace {

// Three passes 6 m wide, side by side.
std::vector<FootprintM> three_passes() {
  return {{{{0, -6}, {100, -6}}, 3}, {{{0, 0}, {100, 0}}, 3}, {{{0, 6}, {100, 6}}, 3}};
}
const WindowM everything{{0, 0}, {1, 0}, 0, 100};

}  // namespace

TEST_CASE("passes side by side miss and repeat nothing") {
  CHECK(area_in(everything, three_passes(), {}, three_passes()).sum_m2() == Approx(0).margin(1e-9));
  CHECK(area_of(three_passes(), {}, three_passes()).sum_m2() == Approx(0).margin(1e-4));
}

TEST_CASE("a pass flown two metres aside misses and repeats two metres of its length") {
  auto flown = three_passes();
  flown[1] = {{{0, 2}, {100, 2}}, 3};
  for (const WrongArea& wrong :
       {area_in(everything, three_passes(), {}, flown), area_of(three_passes(), {}, flown)}) {
    CHECK(wrong.missed_m2 == Approx(200).margin(1e-3));
    CHECK(wrong.repeated_m2 == Approx(200).margin(1e-3));
  }
}

TEST_CASE("ground inside obstacle circles is not missed") {
  auto flown = three_passes();
  flown.erase(flown.begin() + 1);
  // The circle of 3 m lies within the middle pass.
  const double missed_m2 = 600 - M_PI * 9;
  CHECK(area_of(three_passes(), {{{50, 0}, 3}}, flown).missed_m2 == Approx(missed_m2).margin(0.05));
  CHECK(area_in(everything, three_passes(), {{{50, 0}, 3}}, flown).missed_m2 ==
        Approx(missed_m2).margin(0.3));
}

TEST_CASE("a corner that lies on a line of the window spoils that line at most") {
  // 10.1 m by 6 m less a triangle of 8 m by 4 m; its tip on each line in turn.
  const double width_m = 10.1, count = std::ceil(width_m / 0.25), step_m = width_m / count;
  const WindowM window{{0, 0}, {1, 0}, 0, width_m};
  const FootprintM pass{{{-5, 0}, {20, 0}}, 3};
  for (double k = 4; k < 36; ++k) {
    const RingM triangle{{1, -2}, {9, -2}, {step_m / 2 + k * step_m, 2}};
    const double missed_m2 = area_in(window, {pass}, {}, {}, {triangle}).missed_m2;
    CHECK(missed_m2 == Approx(60.6 - 16).margin(4 * step_m + 0.1));
  }
}

TEST_CASE("the areas of the search are those of the record") {
  const PassM pass{{0, 0}, {100, 0}, 6};
  for (const double aside_m : {-2.0, 0.5, 1.8}) {
    const Room room{{{{50, aside_m}, 3.5}}, {}, {}};
    const auto crowds = crowds_of(pass, targets_of(pass, room), room, 3.2);
    REQUIRE(crowds.size() == 1);
    for (const CrowdOption& option : crowds[0].options) {
      if (option.conduct != Conduct::sprayed) continue;
      auto flown = three_passes();
      PathM path{{0, 0}};
      for (const PointM p : sampled(option.curve, 0.1)) path.push_back(p);
      path.push_back({100, 0});
      flown[1].path = path;
      const WrongArea fast = area_in(everything, three_passes(), room.circles(), flown);
      const WrongArea exact = area_of(three_passes(), room.circles(), flown);
      CHECK(fast.missed_m2 == Approx(exact.missed_m2).margin(0.02 * exact.sum_m2()));
      CHECK(fast.repeated_m2 == Approx(exact.repeated_m2).margin(0.02 * exact.sum_m2()));
    }
  }
}

TEST_CASE("a boom wider than the turn sprays again what its inner end runs back over") {
  // Half width 4, radius 3, half a turn: the inner end draws half a circle of 1 m.
  CHECK(backswept_m2(M_PI, 3, 4) == Approx(M_PI / 2));
  CHECK(backswept_m2(M_PI, 4, 4) == 0);
}
