#pragma once
// Legs between corners, flown from rest to rest by an aircraft that has mass.

#include "core/corner.hpp"
#include "core/geometry.hpp"
#include "core/vehicle.hpp"

#include <cstddef>
#include <vector>

namespace furrow::scheduler {

/// Legs shorter than this have no length.
inline constexpr double same_place_m = 1e-6;

/// One sortie in the air.
struct SortieTimes {
  double until_sprayed_s;  ///< From take-off to its last sprayed cell.
  double home_s;           ///< From there to standing at the station.
};

/// A straight leg.
struct Leg {
  double x, y;  ///< Unit vector.
  double length_m, limit_mps;
  Corner corner;  ///< Where it ends.
};

/// Legs one after another.
class Legs {
 public:
  explicit Legs(FieldPoint start) : at_{start} {}

  /// A leg of no length is left out; the leg before takes its corner where that allows less.
  void add(FieldPoint to, Speed limit, Corner corner);
  void add(const Leg& leg) { legs_.push_back(leg); }

  const std::vector<Leg>& all() const { return legs_; }
  std::size_t count() const { return legs_.size(); }

 private:
  FieldPoint at_;
  std::vector<Leg> legs_{};
};

/// A long way that many flights share a middle of. What lies between is timed once: a flight that
/// has come up to the speed of the long way somewhere, and does not brake for its own end yet, goes
/// on as the long way does.
class LegTimes {
 public:
  /// @param way  All legs; may be none.
  LegTimes(const Vehicle& vehicle, std::vector<Leg> way);

  const std::vector<Leg>& way() const { return way_; }

  /// Legs of the way by number: `first` is a flight's own leg too and so is `last`, those between
  /// are the way's alone. @pre first < last.
  struct Shared {
    std::size_t first, last;
  };

  /// @param sprayed_legs  After so many legs the last cell is sprayed: in the middle of an arc.
  SortieTimes of(const std::vector<Leg>& legs, std::size_t sprayed_legs) const;

  /// The same of a flight by `head`, whose last leg is `shared.first`, the way's legs, and `tail`,
  /// whose first leg is `shared.last`.
  /// @param sprayed_legs  Of `tail`.
  SortieTimes of(const std::vector<Leg>& head, Shared shared, const std::vector<Leg>& tail,
                 std::size_t sprayed_legs) const;

 private:
  struct Stretch {  // a leg's straight, or the corner after it
    double length_m, limit_mps;
    double entry_mps = 0;  // from which all that follows can be kept
  };
  using Stretches = std::vector<Stretch>;
  struct Turn {
    double cut_m;  // of either leg
    Stretch arc;
  };
  class Clock;

  Turn turn(const Leg& in, const Leg& out) const;
  Stretches stretches_of(const std::vector<Leg>& legs, double before_m, double after_m) const;
  double plan_entry(Stretch& stretch, double exit_mps, double before_mps) const;
  double plan_entries(Stretches& stretches, double exit_mps, double before_mps) const;
  static SortieTimes finished(Clock clock, const Stretches& last, std::size_t sprayed_legs);

  double acceleration_mps2_, cut_m_, least_radius_m_;
  std::vector<Leg> way_;
  Stretches stretches_{};                       // of the way: each leg's straight, then its corner
  std::vector<double> entered_mps_{}, at_s_{};  // each of them, flown from rest at the beginning
};

}  // namespace furrow::scheduler
