#include "planner/avoidance/dubins.hpp"

#include "core/random.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace furrow;
using namespace furrow::planner;
using std::numbers::pi;

namespace {

double polyline_m(const PathM& path) { return length_m(path); }

}  // namespace

TEST_CASE("a turn to the next strip but one is a half circle of half their distance") {
  // Two strips 10 m apart flown to and fro at R = 5: 5 pi.
  const CurveM turn = dubins_curve({at_m(0, 0), pi / 2}, {at_m(10, 0), -pi / 2}, metres(5));
  CHECK(length_m(turn) == Approx(5 * pi).margin(1e-9));
}

TEST_CASE("a turn to the neighbouring strip is an omega wider than the strips are apart") {
  // Distance d = 4 < 2 R = 10: left, right, left with centres of the outer circles d + 2 R apart
  // and of the middle circle 2 R from both. Angle at the outer centre: cos a = (d + 2 R) / (4 R) =
  // 0.7; the outer arcs turn by a, the middle one by pi + 2 a.
  const double a = std::acos(14.0 / 20.0);
  const CurveM turn = dubins_curve({at_m(0, 0), pi / 2}, {at_m(4, 0), -pi / 2}, metres(5));
  CHECK(length_m(turn) == Approx(5 * (a + pi + 2 * a + a)).margin(1e-9));
}

TEST_CASE("closed length, sampled length and end of Dubins paths agree") {
  Random random{7};
  for (int i = 0; i < 300; ++i) {
    const auto pose = [&] {
      return Pose{at_m(random.uniform(-40, 40), random.uniform(-40, 40)), random.uniform(-pi, pi)};
    };
    const Pose from = pose(), to = pose();
    const double radius_m = random.uniform(0.5, 8);
    const CurveM curve = dubins_curve(from, to, metres(radius_m));
    const PoseM end = end_pose(curve);
    CHECK(norm(end.at - PointM{to.at.x.base(), to.at.y.base()}) < 1e-6);
    CHECK(std::abs(wrapped_rad(end.heading_rad - to.heading_rad)) < 1e-6);
    // A chord of angle h falls short of its arc by h^2 / 24: at 1e-4 rad below 1e-9 of the length.
    CHECK(polyline_m(sampled(curve, 1e-4 * radius_m)) == Approx(length_m(curve)).margin(1e-6));
    CHECK(length_m(curve) >= distance(from.at, to.at).base() - 1e-9);
  }
}

TEST_CASE("tangents around a curve never cut its arcs and bend as little as asked") {
  const CurveM curve = dubins_curve({at_m(0, 0), 0.3}, {at_m(3, 9), 2.0}, metres(4));
  const PathM corners = tangent_path(curve, 0.35);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const PointM in = corners[i] - corners[i - 1], out = corners[i + 1] - corners[i];
    CHECK(std::abs(std::atan2(cross(in, out), dot(in, out))) <= 0.35 + 1e-9);
  }
  // The first arc's centre is 4 m beside the start: no leg along it is nearer.
  const double side = curve.bends[0].curvature_per_m > 0 ? 1 : -1;
  const PointM center = side * 4 * PointM{-std::sin(0.3), std::cos(0.3)};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const PointM a = corners[i - 1], b = corners[i];
    const double t = std::clamp(dot(center - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    CHECK(norm(center - (a + t * (b - a))) >= 4 - 1e-9);
  }
  CHECK(corners.front() == curve.start.at);
  CHECK(norm(corners.back() - PointM{3, 9}) < 1e-6);
}
