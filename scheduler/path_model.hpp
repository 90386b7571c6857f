#pragma once
// A covered field as planner::fleet sees it: a path cut anywhere, constant speeds.

#include "core/station.hpp"
#include "core/vehicle.hpp"
#include "planner/coverage/route.hpp"
#include "planner/fleet/problem.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace furrow::scheduler {

/// What accelerating and turning add to a flight.
struct FlightLoss {
  double flight_s = 0.0;  ///< Once, >= 0.
  double hop_s = 0.0;     ///< For each way between two strips, >= 0.
};

/// What a model leaves to what it does not know.
struct ModelMargins {
  std::vector<FlightLoss> losses{};  ///< By aircraft; none when left out.
  double pack_share = 1.0;           ///< Of a pack, planned with; > 0.
  double spare_cells = 0.0;          ///< Of every tank, >= 0.
  double early_s = 0.0;              ///< Down so long before plans have to be, >= 0.
};

/// The route for a search. Cells become stretches of their strip, of equal length; what is sprayed
/// between two strips counts as strip. Tanks are filled at every visit, and packs swapped
/// meanwhile that do not last for the next flight.
///
/// @return  Nothing where a tank does not last for four cells, and on surveys.
std::optional<planner::fleet::FleetProblem> search_model(const planner::Route& route,
                                                         std::span<const Vehicle> vehicles,
                                                         std::span<const Station> stations,
                                                         const ModelMargins& margins);

/// The number of cells of `route` before a position on its search model's path, to the nearest.
std::uint32_t cells_before(const planner::Route& route, const planner::fleet::StripPath& path,
                           double at_m);

/// The position on the path behind so many cells.
double position_m(const planner::Route& route, const planner::fleet::StripPath& path,
                  std::uint32_t cells);

/// A makespan that no plan beats, and what holds the fleet up.
struct MakespanBound {
  double makespan_s;
  std::string name;
};

/// No plan of this route's strips sprays its last cell earlier at constant speeds: cut anywhere, in
/// any order of its stretches, from and to any stations, packs swapped whenever it suits. Strips
/// flown in another order or the other way may be done earlier.
///
/// The best bound of planner::fleet: ways are straight, packs are swapped while tanks are filled.
/// Where cells are sprayed from centre to centre, what corners cut with the valve open can spare is
/// given away: at every hop between two strips, and at both ends of each way to a station.
///
/// @return  0 of no name where no strip has a length.
MakespanBound fleet_bound(const planner::Route& route, std::span<const Vehicle> vehicles,
                          std::span<const Station> stations);

}  // namespace furrow::scheduler
