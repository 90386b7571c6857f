#include "planner/routes/spline.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <limits>

namespace furrow::planner {
namespace {

// Of Gaussian elimination on the rows 1 4 1: c_i = 1 / (4 - c_(i-1)), c_0 = 0.
constexpr std::array<double, most_way_points> elimination = [] {
  std::array<double, most_way_points> c{};
  for (std::size_t i = 1; i < c.size(); ++i) c[i] = 1.0 / (4.0 - c[i - 1]);
  return c;
}();

constexpr WayPoint eliminated(WayPoint p, WayPoint above, double k) {
  return {(6 * p.x_m - above.x_m) * k, (6 * p.y_m - above.y_m) * k, (6 * p.z_m - above.z_m) * k};
}
constexpr WayPoint minus(WayPoint a, double k, WayPoint b) {
  return {a.x_m - k * b.x_m, a.y_m - k * b.y_m, a.z_m - k * b.z_m};
}
constexpr WayPoint mirrored(WayPoint a, WayPoint at) {
  return {2 * at.x_m - a.x_m, 2 * at.y_m - a.y_m, 2 * at.z_m - a.z_m};
}

constexpr Spline::Axis axis(double a, double b, double c, double d) {
  return {(a + 4 * b + c) * (1.0 / 6), (c - a) * 0.5, (a - 2 * b + c) * 0.5,
          (3 * (b - c) + d - a) * (1.0 / 6)};
}

// First of the samples that lie on or after the start of span i of n.
constexpr std::size_t first_sample(std::size_t i, std::size_t n) { return (100 * i + n - 1) / n; }

constexpr std::size_t end_sample(std::size_t i, std::size_t n) {
  return i + 1 == n ? curve_samples : first_sample(i + 1, n);
}
// Where the first sample of span i lies within it, 0 to 1.
constexpr double offset(std::size_t i, std::size_t n) {
  return static_cast<double>(first_sample(i, n) * n - 100 * i) * 0.01;
}

double place(const Spline::Axis& k, double t) { return k.c0 + t * (k.c1 + t * (k.c2 + t * k.c3)); }

double curvature(const Spline::Span& s, double t) {
  const auto first = [t](const Spline::Axis& k) { return k.c1 + t * (2 * k.c2 + t * 3 * k.c3); };
  const auto second = [t](const Spline::Axis& k) { return 2 * k.c2 + t * 6 * k.c3; };
  const double dx = first(s.x), dy = first(s.y), v = std::hypot(dx, dy);
  const double turn = std::abs(dx * second(s.y) - dy * second(s.x));
  if (turn == 0) return 0;
  return v > 0 ? turn / (v * v * v) : std::numeric_limits<double>::infinity();
}

}  // namespace

Spline::Spline(std::span<const WayPoint> p) : spans_{p.size() - 1} {
  require(p.size() >= 2 && p.size() <= most_way_points, "a curve has 2 to 64 way points");
  const std::size_t n = spans_;
  std::array<WayPoint, most_way_points + 2> control;  // shifted by one: control[0] is C_-1
  const auto c = [&](std::size_t i) -> WayPoint& { return control[i + 1]; };
  c(0) = p[0];
  for (std::size_t i = 1; i < n; ++i) {
    c(i) = eliminated(p[i], c(i - 1), elimination[i]);
  }
  c(n) = p[n];
  for (std::size_t i = n; i-- > 1;) c(i) = minus(c(i), elimination[i], c(i + 1));
  control[0] = mirrored(c(1), c(0));
  c(n + 1) = mirrored(c(n - 1), c(n));
  for (std::size_t i = 0; i < n; ++i) {
    const WayPoint* q = &control[i];
    polynomials_[i] = {axis(q[0].x_m, q[1].x_m, q[2].x_m, q[3].x_m),
                       axis(q[0].y_m, q[1].y_m, q[2].y_m, q[3].y_m),
                       axis(q[0].z_m, q[1].z_m, q[2].z_m, q[3].z_m)};
  }
}

WayPoint Spline::at(double u) const {
  const double along = std::clamp(u, 0.0, 1.0) * static_cast<double>(spans_);
  const std::size_t i = std::min(static_cast<std::size_t>(along), spans_ - 1);
  const double t = along - static_cast<double>(i);
  const Span& s = polynomials_[i];
  return {place(s.x, t), place(s.y, t), place(s.z, t)};
}

void sample(const Spline& spline, SampledCurve& into) {
  const std::size_t n = spline.spans();
  for (std::size_t i = 0; i < n; ++i) {
    const Spline::Span s = spline.span(i);
    const std::size_t first = first_sample(i, n);
    const auto count = static_cast<int>(end_sample(i, n) - first);
    const double start = offset(i, n), step = 0.01 * static_cast<double>(n);
    double *x = &into.x_m[first], *y = &into.y_m[first], *z = &into.z_m[first];
    for (int k = 0; k < count; ++k) {
      const double t = start + k * step;
      x[k] = place(s.x, t);
      y[k] = place(s.y, t);
      z[k] = place(s.z, t);
    }
  }
}

double largest_curvature(const Spline& spline) {
  const std::size_t n = spline.spans();
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t first = first_sample(i, n), end = end_sample(i, n);
    for (std::size_t k = first; k < end; ++k) {
      const double t =
          offset(i, n) + static_cast<double>(k - first) * 0.01 * static_cast<double>(n);
      largest = std::max(largest, curvature(spline.span(i), t));
    }
  }
  return largest;
}

}  // namespace furrow::planner
