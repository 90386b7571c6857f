#include "planner/routes/route_cost.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <array>

namespace furrow::planner {
namespace {

constexpr double depth_weight = 10;

// How deep a value lies beyond a range; 0 inside.
double beyond(double value, double low, double high) {
  return std::max(std::max(0.0, low - value), value - high);
}

double beyond(const Scene& s, WayPoint p) {
  return beyond(p.x_m, s.low.x_m, s.high.x_m) + beyond(p.y_m, s.low.y_m, s.high.y_m) +
         beyond(p.z_m, s.low.z_m, s.high.z_m);
}

using PerSample = std::array<double, curve_samples>;

// Four sums at a time: one would wait for each of its additions.
double sum(const PerSample& of) {
  double a = 0, b = 0, c = 0, d = 0;
  for (std::size_t i = 0; i + 4 <= curve_samples; i += 4) {
    a += of[i];
    b += of[i + 1];
    c += of[i + 2];
    d += of[i + 3];
  }
  return a + b + c + d + of[curve_samples - 1];
}

double penalty(const PerSample& depth, double per_sample) {
  const double depths = sum(depth);
  if (depths == 0) return 0;
  PerSample is_deep;
  for (std::size_t i = 0; i < curve_samples; ++i) is_deep[i] = depth[i] > 0 ? 1.0 : 0.0;
  return per_sample * sum(is_deep) + depth_weight * depths;
}

// How deep a place lies in a volume, by the shortest way out; 0 outside.
double depth_in(const KeepOut& volume, WayPoint p) {
  if (p.z_m < volume.bottom_m || p.z_m > volume.top_m) return 0;
  const double side_m = volume.radius_m - std::hypot(p.x_m - volume.x_m, p.y_m - volume.y_m);
  return std::max(0.0, std::min({side_m, p.z_m - volume.bottom_m, volume.top_m - p.z_m}));
}

Spline spline_by(const Scene& scene, std::span<const WayPoint> inner) {
  require(inner.size() + 2 <= most_way_points, "a curve has at most 64 way points");
  std::array<WayPoint, most_way_points> all;
  all[0] = scene.start;
  std::copy(inner.begin(), inner.end(), all.begin() + 1);
  all[inner.size() + 1] = scene.goal;
  return Spline{{all.data(), inner.size() + 2}};
}

}  // namespace

bool is_clear(const Scene& scene, WayPoint p) {
  if (beyond(scene, p) > 0) return false;
  if (p.z_m < scene.surface.height_m(p.x_m, p.y_m) + kept_m(scene)) return false;
  return std::none_of(scene.keep_out.begin(), scene.keep_out.end(),
                      [&](const KeepOut& volume) { return depth_in(volume, p) > 0; });
}

RouteJudge::RouteJudge(const Scene& scene)
    : scene_{scene}, per_sample_{0.05 * distance_m(scene.start, scene.goal)} {}

RouteCost RouteJudge::cost(std::span<const WayPoint> inner) {
  const Spline spline = spline_by(scene_, inner);
  sample(spline, curve_);
  samples_ += curve_samples;
  RouteCost cost{.length_m = 0};
  add_samples(cost);
  if (!scene_.keep_out.empty()) add_keep_out(cost);
  add_limits(spline, cost);
  return cost;
}

void RouteJudge::add_samples(RouteCost& cost) const {
  const auto &x = curve_.x_m, &y = curve_.y_m, &z = curve_.z_m;
  PerSample of;
  for (std::size_t i = 1; i < curve_samples; ++i) {
    const double dx = x[i] - x[i - 1], dy = y[i] - y[i - 1], dz = z[i] - z[i - 1];
    of[i] = std::sqrt(dx * dx + dy * dy + dz * dz);
  }
  of[0] = 0;
  cost.length_m = sum(of);
  const double kept = kept_m(scene_);
  scene_.surface.heights_m(x.data(), y.data(), curve_samples, of.data());
  for (std::size_t i = 0; i < curve_samples; ++i) of[i] = std::max(0.0, of[i] + kept - z[i]);
  cost.terrain = penalty(of, per_sample_);
  const WayPoint low = scene_.low, high = scene_.high;
  for (std::size_t i = 0; i < curve_samples; ++i) {
    of[i] = beyond(x[i], low.x_m, high.x_m) + beyond(y[i], low.y_m, high.y_m) +
            beyond(z[i], low.z_m, high.z_m);
  }
  cost.outside = penalty(of, per_sample_);
}

void RouteJudge::add_keep_out(RouteCost& cost) const {
  for (const KeepOut& volume : scene_.keep_out) {
    for (std::size_t i = 0; i < curve_samples; ++i) {
      const double depth = depth_in(volume, {curve_.x_m[i], curve_.y_m[i], curve_.z_m[i]});
      if (depth > 0) cost.outside += per_sample_ + depth_weight * depth;
    }
  }
}

void RouteJudge::add_limits(const Spline& spline, RouteCost& cost) const {
  const double straight_m = 20 * per_sample_;
  if (std::isfinite(scene_.steepest_climb)) {
    double steepest = 0;
    for (std::size_t i = 1; i < curve_samples; ++i) {
      const double run =
          std::hypot(curve_.x_m[i] - curve_.x_m[i - 1], curve_.y_m[i] - curve_.y_m[i - 1]);
      const double rise = std::abs(curve_.z_m[i] - curve_.z_m[i - 1]);
      if (rise > 0) steepest = std::max(steepest, rise / std::max(run, 1e-9));
    }
    cost.limits += straight_m * std::max(0.0, steepest / scene_.steepest_climb - 1);
  }
  if (scene_.least_turn_radius_m > 0) {
    const double bend = std::min(largest_curvature(spline), 1e6);
    cost.limits += straight_m * std::max(0.0, bend * scene_.least_turn_radius_m - 1);
  }
}

bool RouteJudge::is_clear(WayPoint p) {
  ++samples_;
  return planner::is_clear(scene_, p);
}

bool RouteJudge::is_clear(WayPoint a, WayPoint b, double step_m) {
  const double steps = std::max(1.0, std::ceil(distance_m(a, b) / step_m));
  for (double i = 0; i <= steps; ++i) {
    if (!is_clear(between(a, b, i / steps))) return false;
  }
  return true;
}

std::vector<WayPoint> flown(const Scene& scene, std::span<const WayPoint> inner) {
  SampledCurve curve;
  sample(spline_by(scene, inner), curve);
  std::vector<WayPoint> places;
  for (std::size_t i = 0; i < curve_samples; ++i) {
    places.push_back({curve.x_m[i], curve.y_m[i], curve.z_m[i]});
  }
  return places;
}

}  // namespace furrow::planner
