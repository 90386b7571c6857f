#pragma once
// The return-point problem of one aircraft on its share of a route. Everything in this folder
// solves it or judges solutions of it.

#include "core/station.hpp"
#include "core/vehicle.hpp"
#include "core/work.hpp"
#include "planner/coverage/route.hpp"

#include <cstdint>
#include <vector>

namespace furrow::planner {

/// One aircraft, one station, and n cells to spray in order. Arrays have n entries, in metres and
/// seconds, so that solvers may run over them.
struct ReturnProblem {
  Vehicle vehicle;
  Station station;
  CellRange cells;                 ///< The share, in cells of the route.
  std::vector<double> spray_m;     ///< Sprayed distance from the first cell to cell i; [0] = 0.
  std::vector<double> on_route_s;  ///< Flying time from the first cell to cell i without returning.
  std::vector<double> home_m;      ///< Straight distance from cell i to the station.
  double fly_out_m;                ///< From the aircraft's first position to cell 0.
  std::vector<std::uint32_t> strip_starts;  ///< First cells of strips, rising; [0] = 0.
};

/// The cells after which the aircraft returns: indices into the share, strictly rising, the last
/// cell left out (the way home from there is implied).
using Returns = std::vector<std::uint32_t>;

/// One sortie of a plan: sprays from the centre of cell `first` to the centre of cell `last`.
struct PlannedSortie {
  std::uint32_t first, last;  ///< Indices into the share; `first` was sprayed before, except 0.
  double spray_m;             ///< D_n.
  double fly_out_s, spray_s, fly_back_s;
  std::uint32_t pack;   ///< 1, 2, ...: the battery pack it flies on.
  double battery_used;  ///< Share of the pack's flight endurance this sortie takes.
  /// At the station afterwards; zero after the last sortie.
  double battery_swap_s, fill_s, service_s;
};

/// A solution, with its costs.
struct ReturnPlan {
  Returns returns;
  std::vector<PlannedSortie> sorties;  ///< returns.size() + 1.
  double non_spray_s;  ///< E of equation (7): round trips and services, the last way home left out.
  double round_trips_m;  ///< Sum of 2 |P_n - P_0| over the returns.
  std::uint32_t swaps;
};

/// The problem of `vehicle` on `cells` of `route`, served at `station`.
/// @pre `cells` is not empty and within the route.
ReturnProblem return_problem(const Route& route, CellRange cells, const Vehicle& vehicle,
                             const Station& station);

}  // namespace furrow::planner
