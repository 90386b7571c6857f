#pragma once
// The return-point problem of one aircraft on its share of a route. Everything in this folder
// solves it or judges solutions of it.

#include "core/station.hpp"
#include "core/vehicle.hpp"
#include "core/work.hpp"
#include "planner/coverage/route.hpp"
#include "planner/terrain/flight_cost.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace furrow::planner {

/// What ground that is not level makes of the flights of a return problem. Entries as there. What
/// corners, stops and starts take of a pack counts as climb; on a survey over level land too.
struct HillFlights {
  std::vector<FlightCost> back, out;            ///< Ferries; out[0] is the way to the beginning.
  std::vector<double> late_s, resume_late_s;    ///< On the route so far, beyond level flight.
  std::vector<double> climb_s, resume_climb_s;  ///< Pack taken on the route so far by climbing.
};

/// One aircraft, one station, and n cells to spray in order. Arrays have n entries, in metres and
/// seconds, so that solvers may run over them.
///
/// An aircraft that returns after cell i stops spraying at the cell's stop and begins its next
/// sortie at the cell's resume (see planner::CellStop). No sortie ends after cell 0 alone, unless
/// it is the last one: in the arrays of resumes, entry 0 is the beginning of the share.
struct ReturnProblem {
  Vehicle vehicle;
  Station station;
  CellRange cells;                 ///< The share, in cells of the route.
  std::vector<double> spray_m;     ///< Sprayed distance from the beginning to stop i.
  std::vector<double> on_route_s;  ///< Flying time to stop i without returning; between strips at
                                   ///< ferry speed.
  std::vector<double> back_m;      ///< Ferry way from stop i to the station.
  std::vector<double> resume_m;    ///< Sprayed distance at resume i; [0] = 0.
  std::vector<double> resume_s;    ///< Flying time to resume i without returning; [0] = 0.
  std::vector<double> out_m;       ///< Ferry way from the station to resume i; [0]: fly_out_m.
  double fly_out_m;                ///< From the aircraft's first position to the beginning.
  std::vector<std::uint32_t> strip_starts;  ///< First cells of strips, rising; [0] = 0.
  std::optional<HillFlights> hills{};       ///< None on level land to spray. In plan are
                                            ///< the lengths.

  /// Of a pack, left for aircraft that turn for home in time to brake first [s]. 0 but on a survey,
  /// whose aircraft are at full speed wherever they are.
  double kept_s = 0;

  /// Flying times of ferries, from stop i and to resume i.
  double back_s(std::uint32_t i) const {
    return hills ? hills->back[i].time_s : back_m[i] / vehicle.ferry_speed.base();
  }
  double out_s(std::uint32_t i) const {
    return hills ? hills->out[i].time_s : out_m[i] / vehicle.ferry_speed.base();
  }
  /// What the same takes of a pack, and the route to stop i and to resume i, in seconds of level
  /// flight.
  double back_pack_s(std::uint32_t i) const { return hills ? hills->back[i].energy_s : back_s(i); }
  double out_pack_s(std::uint32_t i) const { return hills ? hills->out[i].energy_s : out_s(i); }
  double route_pack_s(std::uint32_t i) const {
    return hills ? on_route_s[i] + hills->climb_s[i] : on_route_s[i];
  }
  double resume_pack_s(std::uint32_t i) const {
    return hills ? resume_s[i] + hills->resume_climb_s[i] : resume_s[i];
  }
};

/// The cells after which the aircraft returns: indices into the share, strictly rising, the last
/// cell left out (the way home from there is implied).
using Returns = std::vector<std::uint32_t>;

/// One sortie of a plan: sprays from resume `first` to stop `last`.
struct PlannedSortie {
  std::uint32_t first, last;  ///< Indices into the share; `first` was sprayed before, except 0.
  double spray_m;             ///< D_n.
  double fly_out_s, spray_s, fly_back_s;
  std::uint32_t pack;   ///< 1, 2, ...: the battery pack it flies on.
  double battery_used;  ///< Share of the pack this sortie takes.
  /// At the station afterwards; zero after the last sortie.
  double battery_swap_s, fill_s, service_s;
};

/// A solution, with its costs.
struct ReturnPlan {
  Returns returns;
  std::vector<PlannedSortie> sorties;  ///< returns.size() + 1.
  /// E of equation (7): round trips and services, the last way home left out. A round trip that
  /// replaces a ferry between strips counts less that ferry, so that first way out + on_route_s +
  /// E is when the last cell is sprayed.
  double non_spray_s;
  double round_trips_m;  ///< Sum over the returns of the ways back and out, 2 |P_n - P_0|.
  std::uint32_t swaps;
};

/// Ferry ways between one station and every cell of a route, in metres.
struct StationLengths {
  std::vector<double> back_m;  ///< From the cell's stop to the station.
  std::vector<double> out_m;   ///< From the station to the cell's resume.
};
StationLengths station_lengths(const Route& route, FieldPoint station);

/// Of some of the cells.
StationLengths part(const StationLengths& whole, CellRange cells);

/// The problem of `vehicle` on `cells` of `route`, served at `station`.
/// @param lengths  Of `cells` and the station.
/// @pre `cells` is not empty and within the route.
ReturnProblem return_problem(const Route& route, CellRange cells, const Vehicle& vehicle,
                             const Station& station, StationLengths lengths);

/// The same where the lengths are needed once only.
ReturnProblem return_problem(const Route& route, CellRange cells, const Vehicle& vehicle,
                             const Station& station);

}  // namespace furrow::planner
