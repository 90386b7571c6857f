#pragma once
// The fleet problem: one path, aircraft that may differ, stations with few bays.

#include "planner/fleet/strip_path.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace furrow::planner::fleet {

/// What one aircraft can do, in metres and seconds. All are greater than zero but `service_s`.
struct Flier {
  double tank_m;                                            ///< Sprayed per tank.
  double pack_s = std::numeric_limits<double>::infinity();  ///< Flown per pack, reserve kept.
  double spray_mps, ferry_mps;
  double service_s = 0.0;  ///< In the bay, beyond what the station takes.
  double sortie_s = 0.0;   ///< Lost in every flight; bounds leave it out.
  double hop_s = 0.0;      ///< Lost besides at every hop of one; bounds leave it out.
  double ready_s = 0.0;    ///< When it can take off first.
  /// Down for good by then. Of the bounds `kinds_bound_s` alone knows of either.
  double until_s = std::numeric_limits<double>::infinity();
  FieldPoint start;  ///< Where it stands at time 0, tank and pack full.
};

/// Where tanks are filled at every visit, and packs swapped that do not last for the next flight.
struct Depot {
  FieldPoint position;
  std::uint32_t bays = 1;  ///< >= 1.
  double service_s = 0.0;
  double fill_s = 0.0;  ///< Besides, for a whole tank; for a part of one so much of it.
  double swap_s = 0.0;  ///< For a pack, meanwhile. Bounds leave it out.
  /// No service begins before the one or ends after the other. Bounds leave both out.
  double opens_s = 0.0, closes_s = std::numeric_limits<double>::infinity();
};

struct FleetProblem {
  StripPath path;
  std::vector<Flier> fliers;  ///< At least one.
  std::vector<Depot> depots;  ///< At least one.
  bool ends_sprayed = false;  ///< The makespan ends with the last spraying, not the last landing.
  /// Ways home count for no more than this: what bounds give away where last ones do not count.
  double most_home_m = std::numeric_limits<double>::infinity();
};

/// A stretch of the path sprayed in one flight.
struct Sortie {
  double from_m, to_m;  ///< Positions on the path, from < to.
  std::uint32_t flier;
  std::uint32_t depot;  ///< Where it lands.
};

/// The sorties of all aircraft. Each flies its own in this order.
using FleetSorties = std::vector<Sortie>;

/// How a plan is flown, by aircraft and by sortie as they stand in the plan.
struct Timetable {
  std::vector<double> leaves_s, lands_s;  ///< By sortie; leaving the start or the bay.
  double makespan_s;                      ///< All have landed for good, or sprayed.
  double non_spray_s;                     ///< Of all aircraft: up to landing, less spraying.
  double wait_s;                          ///< In queues; part of the above.
};

}  // namespace furrow::planner::fleet
