#include "scheduler/takeover.hpp"

#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"
#include "scheduler/forecast.hpp"
#include "scheduler/joint_plan.hpp"
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

/// When it lands for good, if it has its station for itself.
double lands_s(Itinerary it, const Survivor& survivor) {
  it.begins_s = survivor.ready_s;
  const double wait_s = forecast({&it, 1}, {&survivor.station, 1}).queue_wait_s;
  const double air_s = std::accumulate(it.flights_s.begin(), it.flights_s.end(), 0.0);
  const double ground_s = std::accumulate(it.services_s.begin(), it.services_s.end(), 0.0);
  return survivor.ready_s + (air_s + ground_s + it.last_spray_s + it.last_home_s) + wait_s;
}

/// The sorties under the numbers of the whole route.
std::vector<SortieOrder> renumbered(std::vector<SortieOrder> sorties,
                                    const std::vector<std::uint32_t>& cells) {
  for (SortieOrder& sortie : sorties) {
    for (Piece& piece : sortie.pieces) piece.cells.first = cells[piece.cells.first];
  }
  return sorties;
}

/// What planning needs again and again.
struct Desk {
  const Remnant& left;
  std::span<const Survivor> survivors;
  std::vector<Station> stations;  ///< Of all survivors, and what else is open, each once.
  std::vector<std::size_t> at;    ///< By survivor: its station's place among them.
  RouteLengths lengths;           ///< To these stations.
  std::vector<bool> reaches;      ///< By survivor: not yet found unable.
};

Desk desk_for(const Remnant& left, std::span<const Survivor> survivors,
              std::span<const Station> others) {
  Desk desk{.left = left,
            .survivors = survivors,
            .stations = {},
            .at = {},
            .lengths = {},
            .reaches = std::vector(survivors.size(), true)};
  desk.at.reserve(survivors.size());
  for (const Survivor& s : survivors) desk.at.push_back(place_of(s.station, desk.stations));
  for (const Station& s : others) place_of(s, desk.stations);
  desk.lengths = route_lengths(left.route, desk.stations);
  return desk;
}

/// The shares of those that reach, empty ones for the others.
std::vector<Share> cut(const Desk& desk) {
  std::vector<std::vector<Pace>> paces;
  std::vector<double> ready_s;
  std::vector<std::size_t> who;
  FirstFlights flights{desk.left.route};
  for (std::size_t u = 0; u < desk.survivors.size(); ++u) {
    if (!desk.reaches[u]) continue;
    who.push_back(u);
    ready_s.push_back(desk.survivors[u].ready_s);
    paces.push_back({pace(flights, desk.survivors[u].vehicle, desk.survivors[u].station,
                          desk.lengths.home_m[desk.at[u]])});
  }
  std::vector<Share> shares(desk.survivors.size(), Share{});
  if (who.empty()) return shares;
  const std::vector<Share> found = partition(
      {desk.left.route, desk.lengths, paces, std::vector(who.size(), 1.0), std::move(ready_s)});
  for (std::size_t i = 0; i < who.size(); ++i) shares[who[i]] = found[i];
  return shares;
}

/// A share with its return points.
struct Planned {
  Addition addition;
  std::vector<CellSortie> list;  ///< The same, in cells of what is left.
};

/// The share as sorties; none where the survivor cannot fly it.
std::optional<Planned> planned(const Desk& desk, std::size_t u, const Share& share) {
  const Survivor& survivor = desk.survivors[u];
  Planned none{
      .addition = {.sorties = {}, .lands_s = survivor.ready_s, .station = survivor.station},
      .list = {}};
  if (share.strips.count == 0) return none;
  const planner::Route& route = desk.left.route;
  const CellRange cells = cells_of(route, share.strips);
  const ReturnProblem problem =
      planner::return_problem(route, cells, survivor.vehicle, survivor.station,
                              part(desk.lengths.stations[desk.at[u]], cells));
  auto plan = quick_plan(problem);
  if (!plan) return std::nullopt;
  Itinerary flown = itinerary(survivor.vehicle.id, 0, *plan, FlightTimes{route, problem});
  swap_as_flown(std::vector<const ReturnProblem*>(plan->sorties.size(), &problem), *plan, flown);
  const double ends_s = lands_s(flown, survivor);
  if (!is_in_time(survivor.vehicle, ends_s)) return std::nullopt;
  UavPlan uav{.vehicle = survivor.vehicle,
              .station = survivor.station,
              .strips = share.strips,
              .cells = problem.cells,
              .solution = {},
              .visits = {},
              .spray_ends_s = 0,
              .lands_s = 0};
  uav.solution.plan = std::move(*plan);
  const auto station = static_cast<std::uint32_t>(desk.at[u]);
  return Planned{.addition = {.sorties = renumbered(orders(route, uav), desk.left.cells),
                              .lands_s = ends_s,
                              .station = survivor.station},
                 .list = sorties_of(problem.cells, uav.solution.plan.returns, station)};
}

/// All shares as sorties; nothing once a survivor proves unable, which the desk then knows.
std::optional<std::vector<Planned>> all_planned(Desk& desk) {
  const std::vector<Share> shares = cut(desk);
  std::vector<Planned> all;
  for (std::size_t u = 0; u < shares.size(); ++u) {
    auto one = planned(desk, u, shares[u]);
    if (!one) {
      desk.reaches[u] = false;
      return std::nullopt;
    }
    all.push_back(std::move(*one));
  }
  return all;
}

/// The plan of an aircraft on the order flown of what is left, as an addition.
Addition addition_of(const UavPlan& uav, const Remnant& order, const Desk& desk, double ready_s) {
  std::vector<std::uint32_t> cells;
  cells.reserve(order.cells.size());
  for (const std::uint32_t c : order.cells) cells.push_back(desk.left.cells[c]);
  Addition added{.sorties = renumbered(orders(order.route, uav), cells),
                 .lands_s = ready_s,
                 .station = uav.station};
  if (!added.sorties.empty()) added.lands_s = uav.lands_s;
  return added;
}

/// Makes of runs of strips what the joint search makes of them.
void improve(std::vector<Planned>& all, const Desk& desk, const Effort& effort) {
  std::vector<std::size_t> who;
  std::vector<Vehicle> vehicles;
  std::vector<double> ready_s;
  SortieLists start;
  for (std::size_t u = 0; u < all.size(); ++u) {
    if (!desk.reaches[u]) continue;
    who.push_back(u);
    vehicles.push_back(desk.survivors[u].vehicle);
    ready_s.push_back(desk.survivors[u].ready_s);
    start.push_back(std::move(all[u].list));
  }
  const planner::SolveSettings settings{.returns = planner::ReturnStrategy::joint,
                                        .refine = true,
                                        .paper_counting = false,
                                        .iterations = 1,
                                        .masses = 2,
                                        .budget_s = effort.budget_s,
                                        .seed = effort.seed};
  const auto joint =
      joint_plan(desk.left.route, desk.lengths, vehicles, desk.stations, settings, start, ready_s);
  if (!joint) return;
  for (std::size_t i = 0; i < who.size(); ++i) {
    Addition& addition = all[who[i]].addition;
    const UavPlan& uav = joint->flown.uavs[i];
    if (uav.cells.count > 0) {
      addition = addition_of(uav, joint->flown.order, desk, ready_s[i]);
    } else {
      addition = {.sorties = {}, .lands_s = ready_s[i], .station = desk.survivors[who[i]].station};
    }
  }
}

Takeover nobody_takes(std::span<const CellRange> orphans, std::span<const Survivor> survivors) {
  Takeover none{.additions = {}, .nobodys = {orphans.begin(), orphans.end()}};
  for (const Survivor& s : survivors)
    none.additions.push_back({.sorties = {}, .lands_s = s.ready_s, .station = s.station});
  return none;
}

}  // namespace

Takeover take_over(const planner::Route& route, std::span<const CellRange> orphans,
                   std::span<const Survivor> survivors, const Effort& effort,
                   std::span<const Station> stations) {
  if (orphans.empty() || survivors.empty()) return nobody_takes(orphans, survivors);
  const Remnant left = remnant(route, orphans);
  Desk desk = desk_for(left, survivors, stations);
  for (std::size_t able = survivors.size(); able > 0; --able) {
    auto all = all_planned(desk);
    if (!all) continue;
    improve(*all, desk, effort);
    Takeover shared;
    for (Planned& one : *all) shared.additions.push_back(std::move(one.addition));
    return shared;
  }
  return nobody_takes(orphans, survivors);
}

}  // namespace furrow::scheduler
