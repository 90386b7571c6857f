#pragma once

#include "planner/fleet/problem.hpp"

#include <span>

namespace furrow::planner::fleet {

/// In the bay before a sortie, seconds.
double service_s(const FleetProblem& problem, std::uint32_t depot, const Sortie& next);

/// Flight of one sortie, out from a place, over its hops and home, seconds.
double flight_s(const FleetProblem& problem, const Sortie& sortie, FieldPoint from);

/// The finish of a plan without its timetable.
struct Finish {
  double makespan_s;  ///< See FleetProblem::ends_sprayed.
  double total_s;     ///< Sum of all aircraft's last landings.
  double wait_s;
  double late_s;           ///< By which last landings are after the fliers' ends, in all.
  bool is_carried = true;  ///< No flight takes more than a tank or a pack.
};

/// Whether a plan is to be preferred: less time landed too late in all,
/// then the makespan, then the total.
bool is_better(const Finish& a, const Finish& b);

/// Flies plans from time 0. Each depot serves first come first served, those who come at the same
/// instant by number, in the bay that is free first. Aircraft leave the start at once, land after
/// every sortie and are serviced before the next. Keeps its working space, and how long the
/// flights last seen take: for the inside of a search.
///
/// Time O(sorties * log aircraft).
class QueueClock {
 public:
  explicit QueueClock(const FleetProblem& problem);

  Finish finish(std::span<const Sortie> sorties);
  Timetable timetable(std::span<const Sortie> sorties);

 private:
  struct Arrival {
    double at_s;
    std::uint32_t flier, sortie;
  };
  /// A flight that was timed.
  struct Timed {
    double from_m = -1.0, to_m = -1.0;
    std::uint32_t flier = 0, depot = 0, from_depot = 0;
    double flight_s = 0.0;
  };
  void link(std::span<const Sortie> sorties);
  double timed_s(const Sortie& sortie, std::uint32_t from_depot);
  double served_s(const Sortie& landed, const Sortie& next, double arrives_s);
  /// Counts the landing of a flier that has no more to fly.
  void end(const Arrival& last, const Sortie& landed, Finish& finish) const;

  const FleetProblem& problem_;
  std::vector<std::uint32_t> first_, next_;  ///< Sorties by aircraft, a linked list.
  std::vector<std::vector<double>> free_s_;  ///< By depot and bay.
  std::vector<Arrival> arrivals_;            ///< A heap.
  std::vector<double> leaves_s_, lands_s_;
  std::vector<Timed> timed_;  ///< By a hash of the flight.
};

}  // namespace furrow::planner::fleet
