#pragma once

#include "planner/fleet/problem.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace furrow::planner::fleet {

/// In the bay before a sortie, its pack swapped or not, seconds.
double service_s(const FleetProblem& problem, std::uint32_t depot, const Sortie& next,
                 bool swaps = false);

/// Flight of one sortie, out from a place, over its hops and home, seconds.
double flight_s(const FleetProblem& problem, const Sortie& sortie, FieldPoint from);

/// The finish of a plan without its timetable.
struct Finish {
  double makespan_s;  ///< See FleetProblem::ends_sprayed.
  double total_s;     ///< Sum of all aircraft's last landings.
  double wait_s;
  double late_s;  ///< By which last landings and services are after what they end by, in all.
  bool is_carried = true;  ///< No flight takes more than a tank or a pack.
};

/// Whether a plan is to be preferred: less time too late in all, then the makespan, then the total.
bool is_better(const Finish& a, const Finish& b);

/// Flies plans from time 0. Each depot serves first come first served, those who come at the same
/// instant by number, in the bay that is free first, from when it opens on. Aircraft leave the
/// start at once, land after every sortie and are serviced before the next. Keeps its working
/// space, and how long the flights last seen take: for the inside of a search.
///
/// Time O(sorties * log aircraft); where a plan was kept, O(sorties) with a small factor and the
/// rest for those alone who fly otherwise than in it or meet such aircraft at a depot.
class QueueClock {
 public:
  explicit QueueClock(const FleetProblem& problem);

  Finish finish(std::span<const Sortie> sorties);
  /// From now on plans are compared with the one finished last.
  void keep();
  /// Of those in the plan finished last, the sorties that had to be flown for it.
  std::size_t flown() const { return flown_count_; }

  Timetable timetable(std::span<const Sortie> sorties);

 private:
  struct Arrival {
    double at_s;
    std::uint32_t flier, sortie;  ///< The second as arranged.
  };
  static bool is_later(const Arrival& a, const Arrival& b) {
    return a.at_s != b.at_s ? a.at_s > b.at_s : a.flier > b.flier;
  }
  /// A flight that was timed.
  struct Timed {
    double from_m = -1.0, to_m = -1.0;
    std::uint32_t flier = 0, depot = 0, from_depot = 0;
    double flight_s = 0.0;
  };
  /// What becomes of a flier that has no more to fly.
  struct Ended {
    double lands_s = 0.0, ends_s = 0.0;  ///< The second counts for the makespan.
    double wait_s = 0.0;
    double late_s = 0.0;  ///< Its services.
    bool is_carried = true;
  };
  /// A plan, flier by flier.
  struct Flown {
    std::vector<Sortie> sorties;
    std::vector<std::uint32_t> first;  ///< By flier, and the number of all at the end.
    std::vector<Ended> ended;
    std::span<const Sortie> of(std::size_t flier) const {
      return std::span{sorties}.subspan(first[flier], first[flier + 1] - first[flier]);
    }
  };
  void arrange(std::span<const Sortie> sorties);
  void choose();
  void take(std::size_t flier);
  bool meets_taken(std::size_t flier) const;
  void fly(std::uint32_t sortie, std::uint32_t from_depot, double at_s);
  void land(const Arrival& now);
  double timed_s(const Sortie& sortie, std::uint32_t from_depot);
  bool swap_pack(const Sortie& landed, const Sortie& next);
  Ended ended(const Sortie& last, const Ended& so_far, double lands_s) const;
  Finish sum() const;

  const FleetProblem& problem_;
  Flown now_, kept_;
  std::vector<std::uint32_t> place_;      ///< Where the next sortie of a flier is arranged.
  std::vector<std::uint32_t> number_;     ///< In the plan, of sorties as they are arranged.
  std::vector<double> used_s_;            ///< By flier: of the pack on board.
  std::vector<char> is_taken_, is_busy_;  ///< Fliers to fly, and depots that they meet at.
  std::size_t flown_count_ = 0;
  std::vector<std::vector<double>> free_s_;  ///< By depot and bay.
  std::vector<Arrival> arrivals_;            ///< A heap.
  std::vector<double> leaves_s_, lands_s_;   ///< By sortie as arranged.
  std::vector<Timed> timed_;                 ///< By a hash of the flight.
};

}  // namespace furrow::planner::fleet
