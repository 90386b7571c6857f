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

/// Ways in plan between stands and work, as quick as a planner of routes makes
/// them.
///
/// Shortest in plan is quickest unless slopes slow an aircraft down or the
/// ceiling is in the way. Only then are ways searched, from the stand to
/// anchors, the corners of a square grid over the land. What the planner bends
/// around becomes way points, moved about for the aircraft's own time; the ways
/// to a place past those of the four anchors around it are compared with the
/// shortest, and that is left only for one that takes 2 s less there and back
/// together and no more either way, or that is less above the ceiling. Between
/// way points ways keep to the land.
///
/// A way is a function of its ends, the kind of aircraft, and the map. What was
/// asked for is kept, so one thread asks at a time.
class HillWays {
 public:
  /// @param land    The same map over level ground.
  /// @param stands  Ways of all other places are the shortest.
  HillWays(FerryMap land, std::shared_ptr<const Relief> relief, const RouteSettings& search,
           std::span<const FieldPoint> stands);

  /// From `from` to `to`, both included; one of them at a stand, or the way is the shortest.
  /// Between a stand and another place it is the same the other way round. Cost: where slopes are
  /// in the way four profiles of heights, and for each square that is new some more, for each
  /// anchor a search. Asked again: a look-up.
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
    bool beats(const RoundTrip& other, double by_s) const {
      return over_m != other.over_m ? over_m < other.over_m : both_s() < other.both_s() - by_s;
    }
  };

  /// A choice of way, from a stand past some points.
  struct Choice {
    Places points;
    double least_m;  ///< Straight from point to point.
  };
  struct Found {
    Places points;  ///< None: the shortest way.
    Places way;     ///< From the stand past them.
    double over_m;  ///< Above the ceiling.
  };

  std::size_t stand_at(FieldPoint place) const;
  static Goal goal(std::size_t stand, FieldPoint to, const Vehicle& v);
  Places out(FieldPoint from, std::size_t stand, FieldPoint to, const Vehicle& v) const;
  const Found& found(std::size_t stand, FieldPoint to, const Vehicle& v) const;
  Found best(std::size_t stand, FieldPoint to, const Vehicle& v) const;
  bool is_quick(std::size_t stand, FieldPoint to, const Vehicle& v) const;
  const Places& squared(std::size_t stand, FieldPoint to, const Vehicle& v) const;
  Found chosen(std::size_t stand, FieldPoint to, std::vector<Choice> choices,
               const Vehicle& v) const;
  Choice choice(std::size_t stand, Places points, FieldPoint to) const;
  std::vector<Choice> choices(std::size_t stand, FieldPoint to, const Vehicle& v) const;
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
  double lowest_m_, highest_m_;  ///< Of the ground, and of ferries over it.
  bool may_be_over_;             ///< Whether these are above the ceiling.
  // Points to pass on the way to anchors, and to the middles of squares.
  mutable std::map<Goal, Places> anchored_{}, squared_{};
  mutable std::map<Goal, Found> found_{};
};

}  // namespace furrow::planner
