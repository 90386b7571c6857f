#pragma once
// Ferry ways around hills, where over them takes longer.

#include "planner/ferry/ferry_map.hpp"
#include "planner/routes/plan_route.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace furrow::planner {

/// Ways in plan between stands and work, as quick as a planner of routes makes them.
///
/// Shortest in plan is quickest unless slopes slow an aircraft down or the ceiling is in the way.
/// Only then are ways searched, from the stand to anchors, the corners of a square grid over the
/// land. What the planner bends around becomes way points, moved about for the aircraft's own time;
/// the ways to a place past those of the four anchors around it are compared with the shortest, and
/// that is left only for one that takes 2 s less there and back together and no more either way, or
/// that is less above the ceiling. Between way points ways keep to the land.
///
/// A way is a function of its ends, the kind of aircraft, and the map. What was asked for is kept,
/// so one thread asks at a time.
class HillWays {
 public:
  /// @param land    The same map over level ground.
  /// @param stands  Ways of all other places are the shortest.
  HillWays(FerryMap land, std::shared_ptr<const Relief> relief, const RouteSettings& search,
           std::span<const FieldPoint> stands);

  /// From `from` to `to`, both included; one of them at a stand, or the way is the shortest.
  /// Between a stand and another place it is the same the other way round. Cost: two profiles of
  /// heights; where slopes are in the way a few more, and a search for each anchor that is new.
  /// Asked again: a look-up.
  std::vector<FieldPoint> way(FieldPoint from, FieldPoint to, const Vehicle& vehicle) const;

 private:
  using Places = std::vector<FieldPoint>;
  /// What ways depend on of an aircraft.
  struct Kind {
    double ferry_mps, acceleration_mps2, swath_m, radius_m;
    friend constexpr auto operator<=>(const Kind&, const Kind&) = default;
  };
  /// A place as flown to from a stand by a kind.
  struct Goal {
    std::size_t stand;
    Kind kind;
    double x_m, y_m;
    friend constexpr auto operator<=>(const Goal&, const Goal&) = default;
  };
  struct RoundTrip {
    double over_m;         ///< Above the ceiling.
    double out_s, back_s;  ///< Without turns.
    double turns_s;        ///< Of each.
    double both_s() const { return out_s + back_s + 2 * turns_s; }
  };

  std::size_t stand_at(FieldPoint place) const;
  static Goal goal(std::size_t stand, FieldPoint to, const Vehicle& v);
  const Places& points(std::size_t stand, FieldPoint to, const Vehicle& v) const;
  Places best_points(std::size_t stand, FieldPoint to, const Vehicle& v) const;
  std::vector<Places> choices(std::size_t stand, FieldPoint to, const Vehicle& v) const;
  const Places& anchored(std::size_t stand, FieldPoint anchor, const Vehicle& v) const;
  Places searched(std::size_t stand, FieldPoint anchor, const Vehicle& v) const;
  Places settled(FieldPoint stand, Places points, FieldPoint to, const Vehicle& v) const;
  Places past(FieldPoint from, std::span<const FieldPoint> points, FieldPoint to) const;
  Scene scene(FieldPoint stand, FieldPoint to, const Vehicle& v) const;
  RoundTrip flown(const Places& way, const Vehicle& v) const;

  FerryMap land_;
  std::shared_ptr<const Relief> relief_;
  RouteSettings search_;
  std::vector<FieldPoint> stands_;
  // Way points between the ends; none: the shortest way.
  mutable std::map<Goal, Places> anchored_{}, points_{};
};

}  // namespace furrow::planner
