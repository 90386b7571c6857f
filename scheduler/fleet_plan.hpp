#pragma once

#include "core/expected.hpp"
#include "core/time.hpp"
#include "core/vehicle.hpp"
#include "core/work.hpp"
#include "planner/coverage/cover.hpp"
#include "planner/returns/solve.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace furrow::scheduler {

/// A forecast visit to a station, one for each return of a plan.
struct Visit {
  double arrives_s, starts_s, ready_s;  ///< Mission time [s]; starts - arrives is the wait.
  std::uint32_t bay;                    ///< 1 .. bays.
};

/// What one aircraft is to do.
struct UavPlan {
  Vehicle vehicle;
  Station station;             ///< Where its sorties end, but for `landings`.
  CellRange strips;            ///< Its share: contiguous strips of the route; may be empty.
  CellRange cells;             ///< The same in cells of the route.
  planner::Solution solution;  ///< Empty returns and sorties for an empty share.
  std::vector<Visit> visits;   ///< One per return.
  double spray_ends_s;         ///< Forecast mission time of its last sprayed cell; 0 if none.
  double lands_s;
  bool joins_late = false;  ///< Not there at the start, so it has no share.
  /// Where each sortie ends; none: all at `station`.
  std::vector<Station> landings{};
};

/// Where a sortie ends, counted from 0.
inline const Station& landing(const UavPlan& uav, std::size_t sortie) {
  return uav.landings.empty() ? uav.station : uav.landings.at(sortie);
}

/// Makespans of other plans of the same route, for comparison [s].
struct Yardsticks {
  /// Of contiguous shares of whole strips, the return points of each chosen. None of the three
  /// where tank, pack or window do not carry it.
  std::optional<double> shares_s;
  std::optional<double> till_empty_s, simple_s;
  std::uint64_t evaluations;  ///< Plans that the joint search has flown.
  bool is_joint;              ///< The plan is the joint search's.
};

/// Who flies what and when.
struct FleetPlan {
  planner::Route route;
  std::optional<planner::SweepFigures> sweep{};  ///< As of planner::Coverage.
  Length safety{};  ///< That every way keeps from obstacles; 0 of flights high above them.
  double work_direction_deg;  ///< Clockwise from north, as given or as found.
  std::vector<UavPlan> uavs;  ///< In order of id.
  double makespan_s;          ///< Forecast mission time at which the last cell is sprayed.
  double lower_bound_s;       ///< No plan of this route is done earlier at constant speeds.
  std::string bound{};        ///< What holds the fleet up by that bound; empty if none is known: 0.
  std::optional<Yardsticks> yardsticks{};  ///< Where sorties were chosen jointly.
};

/// The place of a station among others, where it is added if it is new.
inline std::size_t place_of(const Station& station, std::vector<Station>& stations) {
  const auto known = std::find_if(stations.begin(), stations.end(),
                                  [&](const Station& s) { return s.id == station.id; });
  const auto place = static_cast<std::size_t>(known - stations.begin());
  if (known == stations.end()) stations.push_back(station);
  return place;
}

}  // namespace furrow::scheduler
