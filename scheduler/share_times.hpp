#pragma once
// How fast a share of a route can be sprayed at best: the measure by which a fleet's work is cut.

#include "core/station.hpp"
#include "core/vehicle.hpp"
#include "planner/coverage/route.hpp"
#include "planner/returns/problem.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace furrow::scheduler {

/// Distances along a route and from it, one entry per cell, in metres.
struct RouteLengths {
  std::vector<double> spray_m;  ///< Sprayed distance up to the stop of the cell.
  std::vector<double> begin_m;  ///< By strip: sprayed distance where it begins.
  std::vector<double> ferry_m;  ///< Distance ferried between strips so far.
  /// By station: half of what a return after the cell adds to the way: to the station and to where
  /// spraying resumes, less the ferry that it replaces (see planner::CellStop).
  std::vector<std::vector<double>> home_m;
  std::vector<planner::StationLengths> stations;  ///< By station.
  std::vector<double> nearest_m;                  ///< The least of these.
};

RouteLengths route_lengths(const planner::Route& route, std::span<const Station> stations);

/// The stations that a share beginning with `cell` may gain by: the four nearest to it, by number.
/// To try more takes a fleet of many stations time and finds nothing.
std::vector<std::uint32_t> near_stations(const RouteLengths& lengths, std::uint32_t cell);

/// What sets the time of a share, in metres and seconds.
struct Pace {
  double spray_mps, ferry_mps;
  double tank_m;                   ///< Sprayed distance per tank, > 0.
  double fill_base_s;              ///< Per return.
  double fill_s_per_m;             ///< Per metre sprayed after the first return.
  std::span<const double> home_m;  ///< By cell: distance to the station, of a RouteLengths.
  /// By strip: way of the first flight to its first cell.
  std::shared_ptr<const std::vector<double>> out_m;
};

/// Ferry ways from homes to where the strips of a route begin, each home measured once.
class FirstFlights {
 public:
  /// @param route  It must outlive them.
  explicit FirstFlights(const planner::Route& route) : route_{route} {}

  /// By strip, in metres.
  std::shared_ptr<const std::vector<double>> from(FieldPoint home);

 private:
  const planner::Route& route_;
  std::map<std::pair<double, double>, std::shared_ptr<const std::vector<double>>> known_m_{};
};

/// @param home_m  Distances from every cell to `station`; they must outlive the pace.
Pace pace(FirstFlights& flights, const Vehicle& vehicle, const Station& station,
          std::span<const double> home_m);

/// A pace that no aircraft of the fleet beats anywhere, from any of the stations: the best of every
/// figure. First flights may also start at a station.
/// @param nearest_m  Distances from every cell to its nearest station.
Pace fastest_pace(const planner::Route& route, std::span<const Vehicle> vehicles,
                  std::span<const Station> stations, std::span<const double> nearest_m);

/// A share that grows strip by strip, and the earliest mission time at which its last cell can be
/// sprayed when battery packs last for ever: the optimum over all choices of return points, by
/// dynamic programming with a sliding-window minimum.
///
/// No plan of the share at this pace is faster. The time does not fall as the share grows.
class GrowingShare {
 public:
  /// An empty share that will begin with strip `first`. The arguments must outlive it.
  GrowingShare(const planner::Route& route, const RouteLengths& lengths, const Pace& pace,
               std::uint32_t first);

  bool can_grow() const;

  /// Takes one more strip. Amortised time O(cells of the strip).
  /// @return  When the last cell of the share is sprayed [s].
  double grow();

  /// The return points behind the time, indices into the share.
  planner::Returns returns() const;

 private:
  struct Candidate {
    std::uint32_t cell;  ///< Of the route: a return is made after it.
    double key_s;
  };

  const planner::Route& route_;
  const RouteLengths& lengths_;
  const Pace& pace_;
  std::uint32_t first_cell_, next_strip_;
  double first_m_;                   ///< Sprayed distance where the share begins.
  double base_s_;                    ///< First flight minus the route time at the first cell.
  std::vector<Candidate> window_{};  ///< Keys rise from `head_` on; a queue in a vector.
  std::size_t head_ = 0;
  std::vector<std::uint32_t> parents_{};  ///< By cell of the share: the return before it, or none.
};

}  // namespace furrow::scheduler
