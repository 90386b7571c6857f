#pragma once
// What an aircraft knows of obstacles that no plan knew, and how it gets past them.

#include "agents/xy.hpp"
#include "core/work.hpp"
#include "planner/avoidance/onboard.hpp"

#include <optional>
#include <vector>

namespace furrow::agents {

using planner::AvoidanceRule;
using StripBend = planner::OnboardBend;  ///< On a strip around what was seen.

/// A ferry around what was seen.
struct FerryBends {
  std::vector<FieldPoint>
      bends;                 ///< Every bend but the ends; none where the straight way is clear.
  bool leaves_land = false;  ///< Between two places on the land, for want of a way on it.
};

class Surroundings {
 public:
  explicit Surroundings(AvoidanceRule rule = {});

  /// @return  Whether it was unknown.
  bool learn(const SeenObstacle& obstacle);

  /// In the order learnt.
  const std::vector<SeenObstacle>& seen() const { return seen_; }

  Length clearance() const { return rule_.clearance; }

  /// Whether a place is nearer to a seen obstacle than the clearance.
  bool is_too_near(FieldPoint place) const { return is_within(place, Length{}); }
  /// The same with `more` added to the clearance.
  bool is_within(FieldPoint place, Length more) const;

  /// How far the straight way from `from` to `to` is clear of all that was seen [m]; nothing: all
  /// of it.
  std::optional<double> clear_m(FieldPoint from, FieldPoint to) const;

  struct ClearPart {
    FieldPoint from, to;
  };
  /// The part of a strip from `from` to `to` that can be flown: it begins and ends clear of all
  /// that was seen, and behind or before an obstacle so near to an end that no detour fits there.
  /// @return  Nothing where no end is clear.
  std::optional<ClearPart> clear_part(FieldPoint from, FieldPoint to, Length swath) const;

  /// Way points of a detour on a strip from `from` to `to`: inside the land, arcs of the turn
  /// radius, side and valve by length and ground missed or sprayed twice. Every bend but the ends.
  /// None where the straight way is clear.
  /// @return  Nothing where no detour fits.
  std::optional<std::vector<StripBend>> strip_bends(FieldPoint from, FieldPoint to,
                                                    Length swath) const;

  /// Those of a ferry: inside the land where there is a way, else outside; tighter
  /// turns where arcs of the turn radius do not fit, corners where none do; out of the clearance
  /// first, where it begins too near.
  /// @return  Nothing where it ends too near to an obstacle.
  std::optional<FerryBends> ferry_bends(FieldPoint from, FieldPoint to) const;

 private:
  double kept_m(const SeenObstacle& obstacle) const;
  double leaves_m(const SeenObstacle& obstacle, Xy from, Xy ahead) const;
  std::optional<double> first_clear_m(Xy from, Xy ahead, double length_m, double at_m) const;
  std::vector<double> beginnings_m(Xy from, Xy ahead, double length_m) const;
  std::optional<FieldPoint> way_out(FieldPoint from) const;

  AvoidanceRule rule_;
  std::vector<SeenObstacle> seen_{};
  planner::Room room_, open_room_;  ///< All that is known; and the same without the boundary.
};

}  // namespace furrow::agents
