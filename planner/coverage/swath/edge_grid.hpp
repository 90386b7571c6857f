#pragma once

#include "planner/coverage/plane.hpp"

#include <cstddef>
#include <vector>

namespace furrow::planner {

/// The edges of one piece of land, found by place.
class EdgeGrid {
 public:
  struct Edge {
    PointM from, to;  ///< Land on the left.
    int ring;         ///< 0 is the outer ring.
    int place;        ///< Number of `from` in its ring.
  };

  /// Lengths below this count as none: a place this near to an edge is on it.
  static constexpr double touch_m = 1e-7;

  explicit EdgeGrid(const LandPart& part);

  /// Whether the straight way from `a` to `b` stays on the land; along and through edges and
  /// vertices is allowed. Cost: the edges near the way.
  bool sees(PointM a, PointM b) const;

  /// Whether `p` is on the land or on its edge.
  bool contains(PointM p) const;

  /// The edge on which `p` lies, nullptr if there is none.
  const Edge* edge_at(PointM p) const;

 private:
  std::size_t column_of(double x) const;
  std::size_t line_of(double y) const;
  bool is_left_of_odd(PointM p) const;
  bool is_below_odd(PointM p) const;
  template <class Use>
  void each_near(PointM a, PointM b, Use use) const;

  std::vector<Edge> edges_;
  PointM low_{}, high_{};
  double cell_x_m_ = 1, cell_y_m_ = 1;
  std::size_t columns_ = 1, lines_ = 1;
  std::vector<std::vector<std::size_t>> cells_;   ///< Edges by cell, line by line.
  std::vector<std::vector<std::size_t>> bands_;   ///< Edges by line, each once.
  std::vector<std::vector<std::size_t>> stacks_;  ///< Edges by column, each once.
};

}  // namespace furrow::planner
