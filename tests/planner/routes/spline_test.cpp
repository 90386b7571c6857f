#include "planner/routes/spline.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace furrow::planner {
namespace {

const std::vector<WayPoint> zigzag{{0, 0, 0}, {10, 20, 5}, {30, -10, 8}, {45, 5, 2}, {60, 0, 1}};

double jump(WayPoint a, WayPoint b) { return distance_m(a, b); }

TEST_CASE("The curve passes all way points") {
  const Spline spline{zigzag};
  REQUIRE(spline.spans() == 4);
  for (std::size_t i = 0; i < zigzag.size(); ++i) {
    CHECK(jump(spline.at(static_cast<double>(i) / 4), zigzag[i]) < 1e-9);
  }
}

TEST_CASE("Place, direction and bend are continuous where spans meet, and the ends do not bend") {
  const Spline spline{zigzag};
  for (std::size_t i = 0; i + 1 < spline.spans(); ++i) {
    const auto a = spline.span(i).y, b = spline.span(i + 1).y;
    CHECK(a.c0 + a.c1 + a.c2 + a.c3 == Approx(b.c0));
    CHECK(a.c1 + 2 * a.c2 + 3 * a.c3 == Approx(b.c1));
    CHECK(2 * a.c2 + 6 * a.c3 == Approx(2 * b.c2).margin(1e-9));
  }
  CHECK(spline.span(0).x.c2 == Approx(0).margin(1e-12));
  CHECK(2 * spline.span(3).x.c2 + 6 * spline.span(3).x.c3 == Approx(0).margin(1e-9));
}

TEST_CASE("Three way points give the natural cubic of the book") {
  // y: 0, 1, 0. Controls 0, C, 0 with 0 + 4 C + 0 = 6: C = 1.5. Start slope (C_1 - C_-1) / 2 with
  // C_-1 = -1.5: 1.5. Bend in the middle C_0 - 2 C_1 + C_2 = -3.
  const std::vector<WayPoint> tent{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}};
  const Spline spline{tent};
  CHECK(spline.span(0).y.c1 == Approx(1.5));
  CHECK(2 * spline.span(1).y.c2 == Approx(-3));
  CHECK(spline.span(0).x.c1 == Approx(1));  // evenly spaced x stays even
  // In the middle the slope is level and x' = 1, so the curvature is 3.
  CHECK(largest_curvature(spline) == Approx(3));
}

TEST_CASE("Two way points give the straight line, in a hundred equal steps") {
  const std::vector<WayPoint> ends{{0, 0, 0}, {100, 50, 10}};
  SampledCurve curve;
  sample(Spline{ends}, curve);
  for (std::size_t i = 0; i < curve_samples; ++i) {
    CHECK(curve.x_m[i] == Approx(static_cast<double>(i)).margin(1e-9));
    CHECK(curve.z_m[i] == Approx(0.1 * static_cast<double>(i)).margin(1e-9));
  }
  CHECK(largest_curvature(Spline{ends}) == 0);
}

TEST_CASE("Samples are the curve at steps of 0.01, for any number of way points") {
  for (std::size_t n = 2; n <= most_way_points; ++n) {
    std::vector<WayPoint> points;
    for (std::size_t i = 0; i < n; ++i) {
      const double k = static_cast<double>(i);
      points.push_back({3 * k, static_cast<double>(i * i % 7), k / 2});
    }
    const Spline spline{points};
    SampledCurve curve;
    sample(spline, curve);
    for (std::size_t k = 0; k < curve_samples; ++k) {
      const WayPoint p{curve.x_m[k], curve.y_m[k], curve.z_m[k]};
      REQUIRE(jump(p, spline.at(0.01 * static_cast<double>(k))) < 1e-9);
    }
  }
}

}  // namespace
}  // namespace furrow::planner
