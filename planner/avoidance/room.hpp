#pragma once

#include "planner/coverage/plane.hpp"
#include "planner/coverage/swath/edge_grid.hpp"

#include <cstddef>
#include <vector>

namespace furrow::planner {

struct CircleM {
  PointM center;
  double radius_m;
};

/// A polygon to stay out of and away from.
struct BarrierM {
  RingM ring;          ///< At least 3 vertices.
  double clearance_m;  ///< From its edges, >= 0.
};

double distance_m(PointM p, const PathM& path);

/// Where an aircraft may fly: inside the land, outside circles, clear of barriers.
class Room {
 public:
  /// @param inside  Parts that do not touch; none: anywhere.
  Room(std::vector<CircleM> circles, std::vector<BarrierM> barriers, const LandParts& inside);

  /// The same with more circles.
  Room with(std::vector<CircleM> more) const;

  /// The same land and barriers with these circles.
  Room with_only(std::vector<CircleM> circles) const;

  const std::vector<CircleM>& circles() const { return circles_; }
  const std::vector<BarrierM>& barriers() const { return barriers_; }

  /// Circles that come within `more_m` of the straight way from `a` to `b`, in order of number.
  std::vector<std::size_t> circles_near(PointM a, PointM b, double more_m) const;

  /// Circles that `path` enters by more than rounding, in order of number.
  std::vector<std::size_t> entered(const PathM& path) const;

  /// Whether `path` stays on one part of the land.
  bool is_inside(const PathM& path) const;

  /// Whether it keeps clear of every barrier.
  bool is_clear_of_barriers(const PathM& path) const;

  /// Whether it keeps clear of every circle and barrier.
  bool is_clear(const PathM& path) const {
    return is_clear_of_barriers(path) && entered(path).empty();
  }

  /// Whether it also stays on one part of the land.
  bool is_free(const PathM& path) const { return is_clear(path) && is_inside(path); }

 private:
  bool is_clear_of(const BarrierM& barrier, const PathM& path) const;

  std::vector<CircleM> circles_;
  std::vector<std::size_t> by_x_;  ///< Numbers of circles, centres from west to east.
  double widest_m_ = 0;
  std::vector<BarrierM> barriers_;
  std::vector<EdgeGrid> parts_;
};

}  // namespace furrow::planner
