#include "planner/terrain/terrain.hpp"

#include "core/random.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace furrow::planner {
namespace {

const Extent square{at_m(0, 0), at_m(400, 300)};

AnalyticTerrain hilly() {
  return {.base = BaseTerrain{.a = 1,
                              .b = 0.5,
                              .c = 1,
                              .d = 0.5,
                              .e = 0.7,
                              .f = 0.3,
                              .g = 0.4,
                              .wave = metres(40),
                              .rise = metres(5)},
          .peaks = {{.top = at_m(100, 120),
                     .height = metres(80),
                     .extent_x = metres(60),
                     .extent_y = metres(45)},
                    {.top = at_m(300, 200),
                     .height = metres(50),
                     .extent_x = metres(40),
                     .extent_y = metres(90)}}};
}

TEST_CASE("The height is that of the formula, and of the peaks where they are higher") {
  // Z1(0, 0) = sin(a) + c cos 0 + e cos 0 = sin(1) + 1 + 0.7, times 5 m.
  AnalyticTerrain terrain = hilly();
  terrain.peaks.clear();
  CHECK(height(terrain, at_m(0, 0)).base() == Approx(5 * (std::sin(1.0) + 1.7)));
  // Z1(80 m, 0) = sin(1) + 0.5 sin 2 + cos(0.5 * 2) + 0.7 + 0.3 sin(0.4 * 2)
  CHECK(height(terrain, at_m(80, 0)).base() ==
        Approx(5 *
               (std::sin(1.0) + 0.5 * std::sin(2.0) + std::cos(1.0) + 0.7 + 0.3 * std::sin(0.8))));
  // A peak alone: 80 exp(-1) one extent east of its top; the base, at most 17.5 m, lies lower.
  terrain.peaks = {hilly().peaks.front()};
  CHECK(height(terrain, at_m(160, 120)).base() == Approx(80 * std::exp(-1.0)));
}

TEST_CASE("A tabulated formula lies nowhere further under the truth than it says") {
  const AnalyticTerrain terrain = hilly();
  for (const double tolerance_m : {0.05, 0.5, 3.0}) {
    const Surface table = surface(terrain, square, metres(tolerance_m));
    CHECK(table.error().base() <= tolerance_m * 1.001);
    Random random{4};
    double worst_m = 0;
    for (int i = 0; i < 50'000; ++i) {
      const FieldPoint p = at_m(random.uniform(0, 400), random.uniform(0, 300));
      worst_m = std::max(worst_m, (height(terrain, p) - table.height(p)).base());
    }
    CHECK(worst_m <= table.error().base());
    CHECK(worst_m > 0.02 * table.error().base());  // the bound is not idle
  }
}

TEST_CASE("A raster is bilinear between its samples and level beyond them") {
  // 0 4
  // 2 10  from north to south: heights[0] is the south-west.
  const Surface raster{{.south_west = at_m(100, 200),
                        .step = metres(10),
                        .columns = 2,
                        .rows = 2,
                        .heights_m = {2, 10, 0, 4}}};
  CHECK(raster.height(at_m(100, 200)).base() == 2);
  CHECK(raster.height(at_m(110, 200)).base() == Approx(10));
  CHECK(raster.height(at_m(105, 205)).base() == Approx(4));  // the mean of the four
  CHECK(raster.height(at_m(105, 200)).base() == Approx(6));
  CHECK(raster.height(at_m(-50, 1000)).base() == Approx(0).margin(1e-9));
  CHECK(raster.error() == metres(0));
  // In the middle: east (8 + 4) / 2 over 10 m, north (-2 - 6) / 2 over 10 m.
  CHECK(raster.slope(at_m(105, 205)).east == Approx(0.6));
  CHECK(raster.slope(at_m(105, 205)).north == Approx(-0.4));
}

TEST_CASE("Many heights at once are those asked for one by one") {
  const Surface table = surface(hilly(), square);
  Random random{9};
  std::vector<double> x, y;
  for (int i = 0; i < 300; ++i) {
    x.push_back(random.uniform(-20, 420));
    y.push_back(random.uniform(-20, 320));
  }
  std::vector<double> heights(x.size());
  table.heights_m(x.data(), y.data(), x.size(), heights.data());
  for (std::size_t i = 0; i < x.size(); ++i) CHECK(heights[i] == table.height_m(x[i], y[i]));
}

}  // namespace
}  // namespace furrow::planner
