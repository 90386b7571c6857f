#pragma once

#include "planner/coverage/plane.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace furrow::planner {

/// Polygons of a few kinds laid over one another, and how large the ground is that so many of each
/// kind cover.
///
/// Between neighbouring vertices and crossings every edge is straight and no two cross, so that
/// widths are linear and the line in the middle tells the area exactly, but for rounding. Measured
/// tile by tile, so that few edges are looked at together.
/// Source: Bentley, Ottmann 1979, IEEE Trans. Comput. C-28(9), 643-647, events of a sweeping line.
class Overlay {
 public:
  static constexpr std::size_t kinds = 3;
  using Counts = std::array<int, kinds>;
  using Use = std::function<void(const Counts&, double area_m2)>;

  /// @param frame  Lines run across its x. Fastest where most edges run along it.
  explicit Overlay(RowFrame frame) : frame_{frame} {}

  /// @param part  Valid, its rings either way round.
  void add(const LandPart& part, std::size_t kind);

  /// Calls `use(counts, area_m2)` for pieces of ground, each with how many polygons of each kind
  /// cover it; ground under none is left out. Deterministic. Cost: some 0.1 ms for 50 edges.
  void measure(const Use& use) const;

 private:
  struct Edge {
    PointM from, to;  ///< In the frame, from.x <= to.x.
    std::size_t kind;
    int turn;  ///< +1 into the polygon on the way up, -1 out of it.
    bool is_upright() const;
    double y_at(double x) const {
      return from.y + (x - from.x) / (to.x - from.x) * (to.y - from.y);
    }
  };
  struct Tile;
  class Mosaic;

  void add_ring(const RingM& ring, bool is_hole, std::size_t kind);

  RowFrame frame_;
  std::vector<Edge> edges_;
};

}  // namespace furrow::planner
