#pragma once
// Where aircraft fly with the valve closed, between a station and the strips.

#include "core/expected.hpp"
#include "core/field.hpp"
#include "planner/plan_error.hpp"
#include "planner/terrain/relief.hpp"

#include <memory>
#include <span>
#include <vector>

namespace furrow::planner {

/// What ferry ways keep to.
struct FerryRule {
  Length margin{};       ///< From boundary, holes and obstacles, as strips keep it; >= 0.
  Length hole_buffer{};  ///< Further from holes and obstacles, >= 0.
  Length corner_cut{};   ///< Aircraft leave their way at most this far before a bend, >= 0.
};

/// Shortest ways over the land, around its holes and obstacles. Without land, the open plane: every
/// way is straight.
///
/// A stand outside the land (a station, a home) has an apron: the ground around it half as far
/// again as the land is away, less holes and obstacles. Parts of a split field are joined through
/// necks of its land, nearer to the edges than the margin; where there are none, where parts come
/// nearest to each other. So no way is over foreign land but from such a stand and across such a
/// gap.
///
/// Bends are moved away from the corner that they pass, so that an aircraft that rounds them off
/// still leaves the corner outside.
class FerryMap {
 public:
  FerryMap() = default;

  /// @param stands  Places on the ground that ways lead to; each makes lengths from it cheap.
  /// @error  field_invalid, nothing_to_spray  See `field_land`.
  /// @error  out_of_reach  A stand lies in an obstacle or has no way to the largest part of the
  ///         land; `detail` says where.
  static Expected<FerryMap, PlanError> over(const Field& field, const FerryRule& rule,
                                            std::span<const FieldPoint> stands);

  /// Whether a way leads to `place`: false on land that holes and obstacles cut off from the
  /// stands.
  bool reaches(FieldPoint place) const;

  /// From `from` to `to`, both included. A place off the map is left by the shortest way.
  std::vector<FieldPoint> way(FieldPoint from, FieldPoint to) const;

  /// Length of the shortest way, its bends not moved. From or to a stand: O(corners); else a
  /// search.
  Length length(FieldPoint from, FieldPoint to) const;

  /// The same to places in order along one straight line, faster from a stand than one by one.
  /// @return  Metres.
  std::vector<double> lengths_m(FieldPoint from, std::span<const FieldPoint> line) const;

  /// The same ways over ground that is not level.
  FerryMap over_ground(Relief relief) const;

  /// The ground, or nothing where it is level.
  const Relief* relief() const { return relief_.get(); }

  /// The way from `from` to `to` with its heights.
  /// @param layer  See Relief::layer_of.
  /// @pre There is a relief.
  AirWay air_way(FieldPoint from, FieldPoint to, Speed speed, Length layer) const;

 private:
  class Ground;
  explicit FerryMap(std::shared_ptr<const Ground> ground) : ground_{std::move(ground)} {}

  std::shared_ptr<const Ground> ground_{};
  std::shared_ptr<const Relief> relief_{};
};

}  // namespace furrow::planner
