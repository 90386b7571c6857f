#pragma once
// Ways through the air, given to one aircraft at a time.

#include "core/messages.hpp"

#include <optional>
#include <vector>

namespace furrow::scheduler {

/// A stretch at which an aircraft is at work, and when it may be there.
struct WorkSite {
  AgentId agent;
  FieldPoint from, to;
  double altitude_m;
  Instant enters, leaves;
};

/// Keeps the flights of a fleet apart: what is claimed is put off until it is clear of all that is
/// given already. An aircraft has one flight at a time, its newest.
///
/// Aircraft on their way are where their tracks say within 1.5 m in plan and 0.3 m in height, at
/// work within 0.5 m of their line: so much more than the distance is kept.
///
/// Time O(n p) for each instant tried, n flights and p places of the longest track.
class Airspace {
 public:
  /// That tracks keep beyond the distance, in plan, and the steps in which flights are put off.
  static constexpr double level_room_m = 1.5;
  static constexpr Duration step{500'000'000};

  /// @param distance  That two aircraft in the air keep, > 0.
  explicit Airspace(Length distance);

  /// What to tell the claimant: the same for the same claim, however often it is said. Nothing
  /// where the flight is not clear within two minutes: it may be claimed again.
  /// @param sites  Of all who are at work or on their way to it, the claimant's own from the end of
  /// the flight on, if it is not put off.
  /// @param near   So near to others' work must not be, at the same time, what the flight leads to;
  /// 0: it is near none.
  std::optional<FlightGrant> answer(const FlightClaim& claim, const std::vector<WorkSite>& sites,
                                    Length near, Instant now);

  /// Whether no flight of another that was given passes one of an agent's sites low while it is
  /// worked at, and none of the others' sites is nearer then than `near`.
  bool is_clear(const std::vector<WorkSite>& own, const std::vector<WorkSite>& others, Length near,
                Instant now) const;

  /// Where and when the flight given to an aircraft ends, and the work that it leads to.
  struct Arrival {
    TimedPlace place;
    CellRange leads_to;
  };
  /// None once it has ended.
  std::optional<Arrival> arrival(AgentId agent, Instant now) const;

 private:
  using Track = std::vector<TimedPlace>;
  struct Flight {
    AgentId agent;
    CellRange leads_to;
    FlightGrant grant;
    Track track;
  };

  /// A low part of a track by a site near it, or a site by another: when the claimant is there, if
  /// it is not put off, and when the other is.
  struct Pass {
    Instant enters, leaves;
    Instant other_enters, other_leaves;

    /// Whether both are there at a time, the claimant put off.
    bool meets(Duration delay) const {
      const Instant left = leaves == never ? never : leaves + delay;
      return left >= other_enters && enters + delay <= other_leaves;
    }
  };

  std::vector<Pass> passes(const FlightClaim& claim, const std::vector<WorkSite>& sites,
                           Length near, Instant now) const;
  static void add_near(const WorkSite& own, const std::vector<WorkSite>& others, Length near,
                       Instant now, std::vector<Pass>& found);
  void add_passes(const Track& track, const WorkSite& site, bool is_own,
                  std::vector<Pass>& found) const;
  bool is_clear(const FlightClaim& claim, const std::vector<Pass>& passes, Duration delay) const;
  std::optional<Duration> delay(const FlightClaim& claim, const std::vector<Pass>& passes,
                                Instant now) const;
  FlightGrant book(const FlightClaim& claim, Duration delay);

  // That tracks keep of each other in plan and in height, and of the lines of those at work.
  double level_m_, upright_m_, line_m_;
  std::vector<Flight> flights_;
};

}  // namespace furrow::scheduler
