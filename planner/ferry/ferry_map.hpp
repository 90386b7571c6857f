#pragma once
// Where aircraft fly with the valve closed, between a station and the strips.

#include "core/expected.hpp"
#include "core/field.hpp"
#include "core/vehicle.hpp"
#include "planner/plan_error.hpp"
#include "planner/routes/plan_route.hpp"
#include "planner/terrain/relief.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace furrow::planner {

class HillWays;

/// What ferry ways keep to.
struct FerryRule {
  Length margin{};       ///< From boundary, holes and obstacles, as strips keep it; >= 0.
  Length hole_buffer{};  ///< Further from holes and obstacles, >= 0.
  Length safety{};       ///< From obstacles at least, whatever the others are; >= 0.
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

  /// Whether ferries may fly over `place`.
  bool is_open(FieldPoint place) const;

  /// From `from` to `to`, both included. A place off the map is left by the shortest way.
  std::vector<FieldPoint> way(FieldPoint from, FieldPoint to) const;

  /// Length of the shortest way, its bends not moved. From or to a stand: O(corners); else a
  /// search.
  Length length(FieldPoint from, FieldPoint to) const;

  /// The same to places in order along one straight line, faster from a stand than one by one.
  /// @return  Metres.
  std::vector<double> lengths_m(FieldPoint from, std::span<const FieldPoint> line) const;

  /// The same ways over ground that is not level.
  /// @param search  How ferries look for ways past hills; none: theirs are the shortest in plan.
  FerryMap over_ground(Relief relief, const std::optional<RouteSettings>& search = {}) const;

  /// The ground, or nothing where it is level.
  const Relief* relief() const { return relief_.get(); }

  /// As `vehicle` flies from `from` to `to` in plan, both included: the shortest way, or the one
  /// past hills that it flies between a stand and its work (see HillWays).
  std::vector<FieldPoint> ferry_way(FieldPoint from, FieldPoint to, const Vehicle& vehicle) const;

  /// Length of that way.
  Length ferry_length(FieldPoint from, FieldPoint to, const Vehicle& vehicle) const;

  /// Whether ways of ferries may be other than the shortest.
  bool leads_past_hills() const { return hill_ways_ != nullptr; }

 private:
  class Ground;
  explicit FerryMap(std::shared_ptr<const Ground> ground) : ground_{std::move(ground)} {}

  std::shared_ptr<const Ground> ground_{};
  std::shared_ptr<const Relief> relief_{};
  std::shared_ptr<const HillWays> hill_ways_{};
};

}  // namespace furrow::planner
