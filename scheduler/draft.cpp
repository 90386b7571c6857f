#include "scheduler/draft.hpp"

#include "core/require.hpp"
#include "planner/returns/evaluate.hpp"

#include <algorithm>

namespace furrow::scheduler {
namespace {

constexpr int rounds = 4;

/// Everything a draft is made of; the rounds share it.
struct Desk {
  const planner::Route& route;
  const RouteLengths& lengths;
  std::span<const Vehicle> vehicles;
  std::span<const Station> stations;
  std::vector<std::vector<Pace>> paces;
};

/// The share flown with the return points that are best without battery and queue.
Itinerary rough_itinerary(const Desk& desk, std::size_t uav, const Share& share) {
  const Vehicle& vehicle = desk.vehicles[uav];
  if (share.strips.count == 0) return grounded(vehicle.id);
  GrowingShare growing{desk.route, desk.lengths, desk.paces[uav][share.station],
                       share.strips.first};
  for (std::uint32_t s = 0; s < share.strips.count; ++s) growing.grow();
  const CellRange cells = cells_of(desk.route, share.strips);
  const auto problem =
      planner::return_problem(desk.route, cells, vehicle, desk.stations[share.station],
                              part(desk.lengths.stations[share.station], cells));
  Itinerary it =
      itinerary(vehicle.id, share.station, planner::evaluated(problem, growing.returns()),
                FlightTimes{desk.route, problem});
  it.begins_s = vehicle.available_from.base();
  return it;
}

std::vector<double> ready_s(std::span<const Vehicle> vehicles) {
  std::vector<double> all_s;
  all_s.reserve(vehicles.size());
  for (const Vehicle& v : vehicles) all_s.push_back(v.available_from.base());
  return all_s;
}

/// Changes stations, aircraft by aircraft, where the forecast gains by it.
Draft with_best_stations(const Desk& desk, std::vector<Share> shares) {
  std::vector<Itinerary> itineraries;
  for (std::size_t u = 0; u < shares.size(); ++u) {
    itineraries.push_back(rough_itinerary(desk, u, shares[u]));
  }
  FleetEnds fleet{std::move(itineraries), desk.stations};
  for (std::size_t u = 0; u < shares.size(); ++u) {
    if (shares[u].strips.count == 0) continue;
    const std::uint32_t first = desk.route.strips[shares[u].strips.first].cells.first;
    for (const std::uint32_t s : near_stations(desk.lengths, first)) {
      if (s == shares[u].station) continue;
      Share moved = shares[u];
      moved.station = s;
      Itinerary other = rough_itinerary(desk, u, moved);
      if (worth(fleet.with(u, other)) >= worth(fleet.spray_ends_s())) continue;
      fleet.change(u, std::move(other));
      shares[u] = moved;
    }
  }
  return {std::move(shares), forecast(fleet.itineraries(), desk.stations)};
}

}  // namespace

Draft draft(const planner::Route& route, const RouteLengths& lengths,
            std::span<const Vehicle> vehicles, std::span<const Station> stations) {
  require(!vehicles.empty() && !stations.empty(), "a fleet has aircraft and stations");
  Desk desk{route, lengths, vehicles, stations, {}};
  FirstFlights flights{route};
  for (const Vehicle& v : vehicles) {
    auto& by_station = desk.paces.emplace_back();
    for (std::size_t s = 0; s < stations.size(); ++s) {
      by_station.push_back(pace(flights, v, stations[s], lengths.home_m[s]));
    }
  }
  PartitionProblem problem{route, lengths, desk.paces, std::vector(vehicles.size(), 1.0),
                           ready_s(vehicles)};
  Draft best;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Share> shares = partition(problem);
    Draft drafted = with_best_stations(desk, shares);
    for (std::size_t u = 0; u < shares.size(); ++u) {
      if (shares[u].finish_s <= problem.ready_s[u])
        continue;  // nothing to spray, or one cell at home
      // Half way, since waits move with the cut that they are measured at.
      const double since_s = problem.ready_s[u];
      const double seen = problem.stretch[u] * (drafted.forecast.spray_ends_s[u] - since_s) /
                          (shares[u].finish_s - since_s);
      problem.stretch[u] = 0.5 * (problem.stretch[u] + seen);
    }
    if (round == 0 || worth(drafted.forecast) < worth(best.forecast)) best = std::move(drafted);
  }
  return best;
}

std::vector<Share> recut(const planner::Route& route, const RouteLengths& lengths,
                         std::span<const Vehicle> vehicles, std::span<const Station> stations,
                         const std::vector<Share>& shares, const std::vector<double>& finishes_s) {
  std::vector<std::vector<Pace>> paces;  // from the one station that each aircraft keeps
  std::vector<double> stretch;
  FirstFlights flights{route};
  for (std::size_t u = 0; u < vehicles.size(); ++u) {
    const std::uint32_t s = shares[u].station;
    paces.push_back({pace(flights, vehicles[u], stations[s], lengths.home_m[s])});
    GrowingShare growing{route, lengths, paces[u][0], shares[u].strips.first};
    double predicted_s = 0.0;
    for (std::uint32_t n = 0; n < shares[u].strips.count; ++n) predicted_s = growing.grow();
    const double since_s = vehicles[u].available_from.base();
    stretch.push_back(predicted_s > 0.0 ? (finishes_s[u] - since_s) / predicted_s : 1.0);
  }
  std::vector<Share> cut =
      partition({route, lengths, paces, std::move(stretch), ready_s(vehicles)});
  for (std::size_t u = 0; u < cut.size(); ++u) cut[u].station = shares[u].station;
  return cut;
}

}  // namespace furrow::scheduler
