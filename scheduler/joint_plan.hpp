#pragma once

#include "planner/returns/solve.hpp"
#include "scheduler/fleet_plan.hpp"
#include "scheduler/forecast.hpp"
#include "scheduler/path_model.hpp"
#include "scheduler/remnant.hpp"
#include "scheduler/share_times.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace furrow::scheduler {

/// A run of cells of a route, sprayed in one flight.
struct CellSortie {
  CellRange cells;        ///< Not empty.
  std::uint32_t station;  ///< Where it ends, as an index.
};

/// A share flown with these returns, every sortie to one station; none of an empty share.
std::vector<CellSortie> sorties_of(CellRange share, const planner::Returns& returns,
                                   std::uint32_t station);

/// By aircraft, in the order flown.
using SortieLists = std::vector<std::vector<CellSortie>>;

/// Sorties along a search model's path as runs of whole cells, cuts moved to the nearest cell that
/// the tank still lasts for. None is shorter than two cells: its cells go to the sortie before or
/// behind it along the path.
SortieLists cell_sorties(const planner::Route& route, const planner::fleet::FleetProblem& model,
                         const planner::fleet::FleetSorties& sorties);

/// The same back: lists as sorties along the model's path.
planner::fleet::FleetSorties model_sorties(const planner::Route& route,
                                           const planner::fleet::FleetProblem& model,
                                           const SortieLists& lists);

/// What aircraft fly when, each on sorties from anywhere on a route.
struct FlownLists {
  Remnant order;              ///< The route in the order flown, aircraft after aircraft.
  std::vector<UavPlan> uavs;  ///< In the order of the lists, on that route.
  std::vector<Itinerary> itineraries;
  Forecast forecast;
};

/// The lists flown through the stations' queues, as `forecast` flies plans.
///
/// @param whole    Of which the lists have every cell once.
/// @param lengths  Of `whole`.
/// @param ready_s  By aircraft: mission time of its first take-off; as soon as it is available when
/// left out.
/// @return  Nothing where a tank or a pack does not carry some sortie.
std::optional<FlownLists> flown_lists(const planner::Route& whole, const RouteLengths& lengths,
                                      std::span<const Vehicle> vehicles,
                                      std::span<const Station> stations, const SortieLists& lists,
                                      std::span<const double> ready_s = {});

struct JointPlan {
  FlownLists flown;
  std::uint64_t evaluations;  ///< Plans that the search has flown.
  /// Makespans of flying until empty and of the simple plan, dealt out to whoever is ready first;
  /// none where tank or pack do not carry them.
  std::optional<double> till_empty_s, simple_s;
};

/// Shares, return points, order and stations of the fleet together, by planner::fleet: by gravity
/// where the settings say so, else by annealing from `start` or from flying until empty. All that
/// they begin with and what they find is flown as `flown_lists` does; the one with the smallest
/// forecast makespan is given. What accelerating and turning add to flights the search knows as a
/// line through the flights of `start`.
///
/// The work is set by the settings' budget, not by time.
///
/// @param start    May leave out everything: then it begins without.
/// @param near     Of what is found, less is thought where aircraft wait for each other at strips
///                 nearer than this (see `waits_at_near_work_s`); 0: they do not.
/// @param threads  Searches that run at a time, at most; 0: all. The plan is the same for any.
/// @return  Nothing where no such plan is carried by tanks and packs with all down in time, or on
/// surveys.
std::optional<JointPlan> joint_plan(const planner::Route& route, const RouteLengths& lengths,
                                    std::span<const Vehicle> vehicles,
                                    std::span<const Station> stations,
                                    const planner::SolveSettings& settings,
                                    const SortieLists& start, std::span<const double> ready_s = {},
                                    Length near = {}, std::size_t threads = 0);

}  // namespace furrow::scheduler
