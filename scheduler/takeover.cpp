#include "scheduler/takeover.hpp"

#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"
#include "scheduler/forecast.hpp"
#include "scheduler/orders.hpp"
#include "scheduler/partition.hpp"
#include "scheduler/remnant.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace furrow::scheduler {
namespace {

using planner::ReturnPlan;
using planner::ReturnProblem;

/// The better of the plans that need no search; none where the share is out of reach.
std::optional<ReturnPlan> quick_plan(const ReturnProblem& problem) {
  auto best = planner::unplanned_plan(problem);
  const auto simple = planner::simple_plan(problem);
  if (!best || (simple && simple->non_spray_s < best->non_spray_s)) best = simple;
  if (!best) return std::nullopt;
  return *best;
}

double flight_s(const Itinerary& it) {
  const double air_s = std::accumulate(it.flights_s.begin(), it.flights_s.end(), 0.0);
  const double ground_s = std::accumulate(it.services_s.begin(), it.services_s.end(), 0.0);
  return air_s + ground_s + it.last_spray_s + it.last_home_s;
}

/// The sorties under the numbers of the whole route.
std::vector<SortieOrder> renumbered(std::vector<SortieOrder> sorties, const Remnant& left) {
  for (SortieOrder& sortie : sorties) {
    for (Piece& piece : sortie.pieces) piece.cells.first = left.cells[piece.cells.first];
  }
  return sorties;
}

/// What planning needs again and again.
struct Desk {
  const Remnant& left;
  std::span<const Survivor> survivors;
  std::vector<Station> stations;  ///< Of all survivors, each once.
  std::vector<std::size_t> at;    ///< By survivor: its station's place among them.
  RouteLengths lengths;           ///< To these stations.
  std::vector<bool> reaches;      ///< By survivor: not yet found unable.
};

Desk desk_for(const Remnant& left, std::span<const Survivor> survivors) {
  Desk desk{.left = left,
            .survivors = survivors,
            .stations = {},
            .at = {},
            .lengths = {},
            .reaches = std::vector(survivors.size(), true)};
  for (const Survivor& s : survivors) {
    const auto known = std::find_if(desk.stations.begin(), desk.stations.end(),
                                    [&](const Station& other) { return other.id == s.station.id; });
    desk.at.push_back(static_cast<std::size_t>(known - desk.stations.begin()));
    if (known == desk.stations.end()) desk.stations.push_back(s.station);
  }
  desk.lengths = route_lengths(left.route, desk.stations);
  return desk;
}

/// The shares of those that reach, empty ones for the others.
std::vector<Share> cut(const Desk& desk) {
  std::vector<std::vector<Pace>> paces;
  std::vector<double> ready_s;
  std::vector<std::size_t> who;
  for (std::size_t u = 0; u < desk.survivors.size(); ++u) {
    if (!desk.reaches[u]) continue;
    who.push_back(u);
    ready_s.push_back(desk.survivors[u].ready_s);
    paces.push_back({pace(desk.left.route, desk.survivors[u].vehicle, desk.survivors[u].station,
                          desk.lengths.home_m[desk.at[u]])});
  }
  std::vector<Share> shares(desk.survivors.size(), Share{});
  if (who.empty()) return shares;
  const std::vector<Share> found = partition(
      {desk.left.route, desk.lengths, paces, std::vector(who.size(), 1.0), std::move(ready_s)});
  for (std::size_t i = 0; i < who.size(); ++i) shares[who[i]] = found[i];
  return shares;
}

/// The share as sorties; none where the survivor cannot fly it.
std::optional<Addition> addition(const Desk& desk, std::size_t u, const Share& share) {
  const Survivor& survivor = desk.survivors[u];
  if (share.strips.count == 0) return Addition{.sorties = {}, .lands_s = survivor.ready_s};
  const planner::Route& route = desk.left.route;
  const std::uint32_t first = route.strips[share.strips.first].cells.first;
  const std::uint32_t stop = end(route.strips[end(share.strips) - 1].cells);
  const ReturnProblem problem =
      planner::return_problem(route, {first, stop - first}, survivor.vehicle, survivor.station,
                              desk.lengths.stations[desk.at[u]]);
  auto plan = quick_plan(problem);
  if (!plan) return std::nullopt;
  const Itinerary flown = itinerary(survivor.vehicle.id, 0, *plan, FlightTimes{route, problem});
  UavPlan uav{.vehicle = survivor.vehicle,
              .station = survivor.station,
              .strips = share.strips,
              .cells = problem.cells,
              .solution = {},
              .visits = {},
              .spray_ends_s = 0,
              .lands_s = 0};
  uav.solution.plan = std::move(*plan);
  return Addition{.sorties = renumbered(orders(route, uav), desk.left),
                  .lands_s = survivor.ready_s + flight_s(flown)};
}

/// All shares as sorties; nothing once a survivor proves unable, which the desk then knows.
std::optional<std::vector<Addition>> additions(Desk& desk) {
  const std::vector<Share> shares = cut(desk);
  std::vector<Addition> all;
  for (std::size_t u = 0; u < shares.size(); ++u) {
    auto added = addition(desk, u, shares[u]);
    if (!added) {
      desk.reaches[u] = false;
      return std::nullopt;
    }
    all.push_back(std::move(*added));
  }
  return all;
}

Takeover nobody_takes(std::span<const CellRange> orphans, std::span<const Survivor> survivors) {
  Takeover none{.additions = {}, .nobodys = {orphans.begin(), orphans.end()}};
  for (const Survivor& s : survivors)
    none.additions.push_back({.sorties = {}, .lands_s = s.ready_s});
  return none;
}

}  // namespace

Takeover take_over(const planner::Route& route, std::span<const CellRange> orphans,
                   std::span<const Survivor> survivors) {
  if (orphans.empty() || survivors.empty()) return nobody_takes(orphans, survivors);
  const Remnant left = remnant(route, orphans);
  Desk desk = desk_for(left, survivors);
  for (std::size_t able = survivors.size(); able > 0; --able) {
    if (auto all = additions(desk)) return {.additions = std::move(*all), .nobodys = {}};
  }
  return nobody_takes(orphans, survivors);
}

}  // namespace furrow::scheduler
