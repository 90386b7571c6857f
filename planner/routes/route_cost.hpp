#pragma once

#include "planner/routes/scene.hpp"
#include "planner/routes/spline.hpp"

#include <cstdint>
#include <span>

namespace furrow::planner {

/// What a curve costs, in metres and metre-like penalties.
struct RouteCost {
  double length_m;     ///< V, of the sampled curve.
  double terrain = 0;  ///< T, for samples under terrain and clearance.
  double outside = 0;  ///< E, for samples outside the box or inside a keep-out volume.
  double limits = 0;   ///< For steps too steep and bends too sharp.
  double total() const { return length_m + terrain + outside + limits; }
  bool is_feasible() const { return terrain == 0 && outside == 0 && limits == 0; }
};

/// Judges routes in a scene and counts the work.
///
/// A sample that breaks a rule costs 5 % of the straight distance from start to goal plus ten times
/// its depth; a limit that is broken r-fold costs r - 1 straight distances.
class RouteJudge {
 public:
  /// Keeps a reference to the scene.
  explicit RouteJudge(const Scene& scene);

  /// Cost of the curve from the start by `inner` to the goal. 1 to 2 us.
  /// @pre at most `most_way_points` - 2 inner way points
  RouteCost cost(std::span<const WayPoint> inner);

  /// As the free function, counted.
  bool is_clear(WayPoint p);

  /// Whether all of the straight line is clear, at steps of at most `step_m`.
  bool is_clear(WayPoint a, WayPoint b, double step_m);

  const Scene& scene() const { return scene_; }

  /// Work in curves: places looked up, by the hundred and one.
  double evaluations() const { return static_cast<double>(samples_) / curve_samples; }

 private:
  void add_samples(RouteCost& cost) const;
  void add_keep_out(RouteCost& cost) const;
  void add_limits(const Spline& spline, RouteCost& cost) const;

  const Scene& scene_;
  double per_sample_;
  std::uint64_t samples_ = 0;
  SampledCurve curve_;
};

/// The curve from start by `inner` to goal as `curve_samples` places.
std::vector<WayPoint> flown(const Scene& scene, std::span<const WayPoint> inner);

}  // namespace furrow::planner
