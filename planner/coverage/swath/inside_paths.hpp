#pragma once

#include "planner/coverage/swath/edge_grid.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace furrow::planner {

/// Shortest ways between places of one connected piece of land that never leave it.
///
/// A shortest way bends only at reflex vertices, and there only around the corner: A* over the
/// visibility graph of these, grown as far as it is asked for and kept between questions.
/// Source: Lozano-Perez, Wesley 1979; bends as tangents after Rohnert 1986.
class InsidePaths {
 public:
  explicit InsidePaths(const LandPart& part);

  /// From `a` to `b`, both included, at least two places.
  /// @return  Nothing if `a` or `b` is not on the land.
  std::optional<PathM> shortest(PointM a, PointM b) const;

  /// Shortest ways from one place to every corner that one may bend at.
  struct Fan {
    PointM from;
    std::vector<double> corner_m;     ///< Lengths; infinite where no way leads.
    std::vector<std::size_t> before;  ///< The corner before each on its way, or `straight`.
    std::vector<double> ring_m;       ///< The least of each ring's corners.
  };
  static constexpr std::size_t straight = static_cast<std::size_t>(-1);
  /// Cost: a search over all corners.
  Fan fan(PointM from) const;

  /// Length of the shortest way from the fan's place to `to`; infinite if there is none.
  /// O(corners).
  double way_m(const Fan& fan, PointM to) const;

  /// That way, both ends included; nothing if there is none.
  std::optional<PathM> way(const Fan& fan, PointM to) const;

  /// Its length, to places in order along one straight line. Where both ends of a stretch are
  /// reached past the same corner and nothing lies between, the places between are too.
  std::vector<double> ways_m(const Fan& fan, std::span<const PointM> line) const;

  /// Whether every place sees every other.
  bool is_convex() const { return corners_.empty(); }

  const EdgeGrid& edges() const { return grid_; }

 private:
  struct Corner {
    PointM at, before, after;  ///< A reflex vertex and its neighbours.
  };
  /// The corners of one ring, numbered in a row, and a circle around them.
  struct RingCorners {
    std::size_t first, stop;
    PointM middle;
    double radius_m;
  };
  struct Link {
    std::size_t to;
    double length_m;
  };

  /// How a place is reached: the last corner on the way, `straight` where there is none.
  struct Arrival {
    double way_m;
    std::size_t past;
  };

  void add_corners(const RingM& ring);
  bool bends_around(PointM from, const Corner& corner) const;
  bool may_bend_to(const Corner& here, const RingCorners& ring) const;
  Arrival arrival(const Fan& fan, PointM to) const;
  Arrival nearest_past(const Fan& fan, PointM to, Arrival known,
                       std::span<const std::size_t> rings) const;
  /// From `from` past the corners that lead to `last`.
  PathM traced(PointM from, const std::vector<std::size_t>& before, std::size_t last,
               PointM to) const;
  std::optional<Arrival> past_within(const Fan& fan, PointM to, double longest_m,
                                     std::span<const std::size_t> rings) const;
  std::vector<std::size_t> rings_near(const Fan& fan, std::span<const PointM> line,
                                      double to_apex_m, PointM apex) const;
  bool is_clear(PointM apex, PointM a, PointM b) const;
  void fill(const Fan& fan, std::span<const PointM> line, Arrival first, Arrival last,
            std::span<double> ways_m) const;
  template <class Use>
  void each_bend_from(std::size_t corner, Use use) const;
  const std::vector<Link>& links_of(std::size_t corner) const;
  std::optional<PathM> along_ring(PointM a, PointM b) const;
  std::optional<PathM> search(PointM a, PointM b, double longest_m) const;

  EdgeGrid grid_;
  std::vector<RingM> rings_;
  std::vector<Corner> corners_;
  std::vector<RingCorners> ring_corners_;                        ///< Of the rings that have some.
  std::vector<std::size_t> all_rings_;                           ///< Numbers of these.
  mutable std::vector<std::optional<std::vector<Link>>> links_;  ///< Filled when first needed.
};

}  // namespace furrow::planner
