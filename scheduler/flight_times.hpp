#pragma once
// How long a sortie takes an aircraft that has mass.

#include "planner/returns/problem.hpp"
#include "scheduler/leg_times.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <vector>

namespace furrow::scheduler {

/// The flights of one aircraft on its share, from rest to rest: where the planner counts constant
/// speeds and sharp corners, these accelerate, brake and turn, in still air.
///
/// The way is flown as aircraft do, by the strips' approaches too. At a corner of angle q an arc
/// leaves both legs c before it, c half a swath or half of the shorter leg, its radius
/// r = c / tan(q / 2); it is flown at sqrt(k a r) at most, where a is the acceleration planned with
/// and k the share of it left to turning. A corner without room for an arc is turned at a stop, as
/// are the ends of strips sprayed from end to end (see Corner). A stretch of length s between
/// speeds u and w takes, at limit v, what its trapezoid takes: ramps at a up to the peak
/// p = min(v, sqrt(a s + (u^2 + w^2) / 2)), and the rest at p. From rest to rest that is s / v + v
/// / a where v is reached, and 2 sqrt(s / a) where not. Speeds from which the next corner could not
/// be met are lowered from the end of the way backwards. Over hills a flight takes longer by what
/// slopes slow it down on the way, as the problem says, and everywhere by the route's detours.
class FlightTimes {
 public:
  /// The route and the problem are copied from, not kept.
  FlightTimes(const planner::Route& route, const planner::ReturnProblem& problem);
  /// @param problems  Of one share, by station; null where nothing ends. One at least.
  FlightTimes(const planner::Route& route, std::span<const planner::ReturnProblem* const> problems);

  /// Stations by their place among the problems.
  struct Ends {
    std::uint32_t from = 0, to = 0;
  };
  /// @param is_first  Whether it starts at the aircraft's first position, not at a station.
  /// Time O(strips in which it comes up to speed or brakes), whatever lies between.
  SortieTimes operator()(const planner::PlannedSortie& sortie, bool is_first, Ends ends) const;
  SortieTimes operator()(const planner::PlannedSortie& sortie, bool is_first) const {
    return (*this)(sortie, is_first, Ends{});
  }

 private:
  struct Run {                  ///< The part of a strip within the share.
    std::uint32_t first, last;  ///< Cells, indices into the share.
    FieldPoint begin;           ///< Where the valve opens before the first.
    /// Where it closes after each cell.
    std::vector<FieldPoint> stops;
    std::vector<FieldPoint> approach;  ///< From the run before.
    bool continues;
    bool to_its_end;  ///< Sprayed from end to end.
    std::size_t leg;  ///< Of the whole share, that sprays it, if it has length.
    FieldPoint stop(std::uint32_t cell) const { return stops[cell - first]; }
    bool has_length() const;
    Corner corner(bool open) const {
      return !to_its_end ? Corner::cut : open ? Corner::held : Corner::stop;
    }
  };

  using Places = std::vector<FieldPoint>;
  struct Stand {
    FieldPoint station;
    std::vector<double> back_m;                       ///< By cell.
    std::vector<double> late_back_s{}, late_out_s{};  ///< By cell: longer than on level land [s].
  };
  void add_stand(const planner::ReturnProblem& problem);
  void lead_on(Legs& legs, std::size_t run) const;
  std::size_t begin(Legs& legs, const planner::PlannedSortie& sortie, bool is_first,
                    std::uint32_t from) const;
  void finish(Legs& legs, std::size_t run, std::uint32_t cell, std::uint32_t to) const;
  void time_share();
  const Places& way_home(std::uint32_t stand, std::uint32_t cell, FieldPoint stop) const;
  const Places& way_out(bool is_first, std::uint32_t stand, std::uint32_t cell,
                        FieldPoint begin) const;

  Vehicle vehicle_;
  planner::FerryMap ferries_;
  std::vector<Stand> stands_{};
  std::vector<double> late_s_{}, resume_late_s_{};  // by cell, as of the stands
  std::vector<double> detours_s_{};  // around obstacles met, in and before each cell of the share
  // As asked for: by cell those that bend, and from home or station to the first cell of a run.
  mutable std::map<std::pair<std::uint32_t, std::uint32_t>, Places> ways_home_{};
  mutable std::map<std::tuple<bool, std::uint32_t, std::uint32_t>, Places> ways_out_{};
  std::vector<Run> runs_{};
  LegTimes share_;
};

}  // namespace furrow::scheduler
