#include "scheduler/joint_plan.hpp"

#include "core/random.hpp"
#include "core/require.hpp"
#include "planner/at_once.hpp"
#include "planner/fleet/gsa_sorties.hpp"
#include "planner/fleet/solve.hpp"
#include "planner/fleet/till_empty.hpp"
#include "planner/returns/evaluate.hpp"
#include "scheduler/even_out.hpp"
#include "scheduler/flight_losses.hpp"
#include "scheduler/turns_at_near_work.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace furrow::scheduler {
namespace {

namespace fleet = planner::fleet;

constexpr std::uint32_t least_cells = 2;

/// Where one aircraft's list lies in the route of all.
struct Share {
  CellRange cells, strips;
  planner::Returns returns;
};

/// A route in the order flown, with who flies what of it.
struct FlownRoute {
  Remnant order;
  std::vector<Share> shares;
};

/// The list's cells as runs as long as can be.
std::vector<CellRange> runs_of(const std::vector<CellSortie>& list) {
  std::vector<CellRange> runs;
  for (const CellSortie& s : list) {
    if (!runs.empty() && end(runs.back()) == s.cells.first) {
      runs.back().count += s.cells.count;
    } else {
      runs.push_back(s.cells);
    }
  }
  return runs;
}

FlownRoute flown_route(const planner::Route& whole, const SortieLists& lists) {
  std::vector<CellRange> runs;
  for (const auto& list : lists) {
    const std::vector<CellRange> own = runs_of(list);
    runs.insert(runs.end(), own.begin(), own.end());
  }
  FlownRoute flown{.order = remnant(whole, runs), .shares = {}};
  planner::Route& route = flown.order.route;
  route.missed = whole.missed;
  std::uint32_t cell = 0, strip = 0;
  for (const auto& list : lists) {
    Share share{.cells = {cell, 0}, .strips = {strip, 0}, .returns = {}};
    for (const CellSortie& s : list) {
      if (share.cells.count > 0) share.returns.push_back(share.cells.count - 1);
      share.cells.count += s.cells.count;
    }
    cell = end(share.cells);
    while (strip < route.strips.size() && route.strips[strip].cells.first < cell) ++strip;
    share.strips.count = strip - share.strips.first;
    flown.shares.push_back(std::move(share));
  }
  return flown;
}

/// The ways of a share to a station in the order flown: those of the whole route, but where strips
/// follow others now.
planner::StationLengths reordered(const Remnant& order, const Share& share,
                                  const planner::StationLengths& whole, FieldPoint station) {
  const planner::Route& route = order.route;
  const std::uint32_t first = share.cells.first;
  planner::StationLengths lengths;
  lengths.back_m.reserve(share.cells.count);
  for (std::uint32_t i = first; i < end(share.cells); ++i) {
    lengths.back_m.push_back(whole.back_m[order.cells[i]]);
  }
  lengths.out_m = lengths.back_m;
  for (std::uint32_t s = share.strips.first + 1; s < end(share.strips); ++s) {
    const planner::Strip& next = route.strips[s];
    if (next.continues) continue;
    const std::uint32_t before = next.cells.first - 1;
    const bool is_as_ever = order.cells[before] + 1 == order.cells[before + 1];
    lengths.out_m[before - first] = is_as_ever ? whole.out_m[order.cells[before]]
                                               : route.ferries.length(next.begin, station).base();
  }
  return lengths;
}

/// Makes the plans of the aircraft one after the other.
class Desk {
 public:
  Desk(const FlownRoute& flown, const RouteLengths& lengths, std::span<const Station> stations)
      : flown_{flown}, lengths_{lengths}, stations_{stations} {}

  /// @return  Nothing where tank or pack do not carry it.
  std::optional<UavPlan> plan(const Vehicle& vehicle, const std::vector<CellSortie>& list,
                              const Share& share);
  /// Of the last plan.
  const Itinerary& itinerary() const { return itinerary_; }

 private:
  const FlownRoute& flown_;
  const RouteLengths& lengths_;
  std::span<const Station> stations_;
  Itinerary itinerary_{};
};

UavPlan grounded_plan(const Vehicle& vehicle, const Station& station, const Share& share) {
  return {.vehicle = vehicle,
          .station = station,
          .strips = share.strips,
          .cells = share.cells,
          .solution = {},
          .visits = {},
          .spray_ends_s = 0,
          .lands_s = 0};
}

const Station& nearest(std::span<const Station> stations, FieldPoint to) {
  return *std::min_element(stations.begin(), stations.end(),
                           [to](const Station& a, const Station& b) {
                             return distance(a.position, to) < distance(b.position, to);
                           });
}

std::optional<UavPlan> Desk::plan(const Vehicle& vehicle, const std::vector<CellSortie>& list,
                                  const Share& share) {
  UavPlan uav = grounded_plan(vehicle, nearest(stations_, vehicle.home), share);
  itinerary_ = grounded(vehicle.id);
  if (list.empty()) return uav;
  std::map<std::uint32_t, planner::ReturnProblem> problems;
  std::vector<const planner::ReturnProblem*> by_station(stations_.size(), nullptr), ends;
  std::vector<std::uint32_t> landings;
  for (const CellSortie& s : list) {
    if (!problems.contains(s.station)) {
      const Station& station = stations_[s.station];
      problems.emplace(s.station, planner::return_problem(
                                      flown_.order.route, share.cells, vehicle, station,
                                      reordered(flown_.order, share, lengths_.stations[s.station],
                                                station.position)));
    }
    by_station[s.station] = &problems.at(s.station);
    ends.push_back(by_station[s.station]);
    landings.push_back(s.station);
    uav.landings.push_back(stations_[s.station]);
  }
  uav.station = uav.landings.back();
  if (problems.size() == 1) uav.landings.clear();
  uav.solution.plan = planner::evaluated(ends, share.returns);
  if (!planner::is_feasible(*ends.front(), uav.solution.plan)) return std::nullopt;
  const FlightTimes times{flown_.order.route, by_station};
  itinerary_ = scheduler::itinerary(vehicle.id, landings, uav.solution.plan, times);
  swap_as_flown(ends, uav.solution.plan, itinerary_);
  uav.solution.objective_s = uav.solution.plan.non_spray_s;
  return uav;
}

std::vector<fleet::Sortie> along(const fleet::FleetSorties& sorties,
                                 std::vector<std::size_t>& order) {
  order.resize(sorties.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return sorties[a].from_m < sorties[b].from_m; });
  std::vector<fleet::Sortie> sorted;
  sorted.reserve(sorties.size());
  for (const std::size_t i : order) sorted.push_back(sorties[i]);
  return sorted;
}

/// Behind the last cell of a sortie that begins with `first`: the nearest, or that which the tank
/// still lasts for.
std::uint32_t stop_of(const planner::Route& route, const fleet::FleetProblem& model,
                      const fleet::Sortie& sortie, std::uint32_t first) {
  constexpr double slack_m = 1e-6;
  std::uint32_t stop = cells_before(route, model.path, sortie.to_m);
  const double tank_end_m =
      position_m(route, model.path, first) + model.fliers[sortie.flier].tank_m + slack_m;
  while (stop > first && position_m(route, model.path, stop) > tank_end_m) --stop;
  return stop;
}

constexpr int attempts = 3;

/// Sorties that a search may fly.
std::uint64_t budget_of(const planner::SolveSettings& settings, double sorties_per_s = 200'000) {
  return static_cast<std::uint64_t>(settings.budget_s * sorties_per_s) + 1;
}

/// How many searches there are, and how much each may fly.
struct Effort {
  std::size_t runs, hot_runs;  ///< Those that are not hot are cool.
  std::uint64_t hot_budget, cool_budget;
};

/// Plans of very many sorties settle in cool searches alone, with the more for each.
Effort effort_of(const planner::SolveSettings& settings, const fleet::FleetProblem& model) {
  constexpr double cool_per_s = 200'000, few = 25.0, many = 200.0;
  double tank_m = 0.0;
  for (const fleet::Flier& f : model.fliers) tank_m = std::max(tank_m, f.tank_m);
  const double tanks = model.path.length_m() / tank_m;
  const std::uint64_t cool = budget_of(settings, cool_per_s * std::max(1.0, tanks / few));
  if (tanks > many) return {.runs = 2, .hot_runs = 0, .hot_budget = 0, .cool_budget = cool};
  return {.runs = 5, .hot_runs = 3, .hot_budget = budget_of(settings) / 3, .cool_budget = cool};
}

std::optional<fleet::FleetSorties> by_gravity(const fleet::FleetProblem& model,
                                              const planner::SolveSettings& settings,
                                              std::uint64_t& evaluations) {
  const auto start = fleet::till_empty(model);
  if (!start) return std::nullopt;
  const std::uint64_t most = budget_of(settings) / (settings.masses * start->size()) + 1;
  const auto iterations =
      static_cast<std::uint32_t>(std::min<std::uint64_t>(settings.iterations, most));
  evaluations += std::uint64_t{settings.masses} * iterations;
  return fleet::gsa_sorties(
      model, {.masses = settings.masses, .iterations = iterations, .seed = settings.seed});
}

std::optional<fleet::FleetSolution> annealed(const fleet::FleetProblem& model,
                                             const planner::SolveSettings& settings,
                                             const Effort& effort, std::size_t run,
                                             const fleet::FleetSorties& start) {
  const bool is_cool = run >= effort.hot_runs;
  fleet::FleetSolveSettings search{.budget = is_cool ? effort.cool_budget : effort.hot_budget,
                                   .seed = seed_for(settings.seed, {run}),
                                   .runs = 1,
                                   .is_cool = is_cool};
  if (!start.empty()) search.starts.push_back(start);
  return fleet::solved(model, search);
}

/// Flies what the search and its starts say, and keeps the best.
class Judge {
 public:
  Judge(const planner::Route& route, const RouteLengths& lengths, std::span<const Vehicle> vehicles,
        std::span<const Station> stations, std::span<const double> ready_s, Length near,
        std::size_t threads)
      : route_{route},
        lengths_{lengths},
        vehicles_{vehicles},
        stations_{stations},
        ready_s_{ready_s},
        near_{near},
        threads_{threads} {}

  /// @return  The makespan, if tanks and packs carry the sorties and all are down in time.
  std::optional<double> consider(const fleet::FleetProblem& model,
                                 const std::optional<fleet::FleetSorties>& sorties) {
    if (!sorties) return std::nullopt;
    return consider(cell_sorties(route_, model, *sorties));
  }
  std::optional<double> consider(SortieLists lists) {
    auto flown = flown_lists(route_, lengths_, vehicles_, stations_, lists, ready_s_);
    if (!flown || !flown->forecast.is_sure || !is_in_time(vehicles_, flown->forecast)) {
      return std::nullopt;
    }
    const double makespan_s = flown->forecast.makespan_s;
    if (const auto loss = loss_of(*flown); !best_ || loss < best_loss_) {
      best_loss_ = loss;
      best_ = std::move(flown);
      best_lists_ = std::move(lists);
    }
    return makespan_s;
  }
  /// The best so far, its aircraft done more nearly together.
  void even_out(const planner::SolveSettings& settings) {
    constexpr double moves_per_s = 300;
    if (!best_) return;
    const auto most = static_cast<std::uint64_t>(settings.budget_s * moves_per_s);
    consider(evened_out(route_, lengths_, vehicles_, stations_, best_lists_, ready_s_, most));
  }
  /// @return  Whether tanks and packs carry anything of what a search finds.
  bool consider_searched(const fleet::FleetProblem& model, const planner::SolveSettings& settings,
                         const fleet::FleetSorties& start) {
    if (settings.returns == planner::ReturnStrategy::gsa) {
      return consider(model, by_gravity(model, settings, evaluations_)).has_value();
    }
    bool is_carried = false;
    const Effort effort = effort_of(settings, model);
    const auto anneal = [&](std::size_t run) {
      return annealed(model, settings, effort, run, start);
    };
    for (const auto& found : planner::at_once(effort.runs, anneal, threads_)) {
      if (!found) continue;
      evaluations_ += found->evaluations;
      is_carried |= consider(model, found->sorties).has_value();
    }
    return is_carried;
  }
  std::uint64_t evaluations() const { return evaluations_; }
  std::optional<FlownLists>& best() { return best_; }

 private:
  const planner::Route& route_;
  const RouteLengths& lengths_;
  std::span<const Vehicle> vehicles_;
  std::span<const Station> stations_;
  std::span<const double> ready_s_;
  Length near_;
  std::size_t threads_;
  /// What a plan is worth, waits at near work told in the makespan.
  std::tuple<double, double> loss_of(const FlownLists& flown) const {
    auto loss = worth(flown.forecast);
    if (near_ > Length{}) std::get<0>(loss) += waits_at_near_work_s(flown, route_, near_);
    return loss;
  }

  std::optional<FlownLists> best_{};
  std::tuple<double, double> best_loss_{};
  SortieLists best_lists_{};
  std::uint64_t evaluations_ = 0;
};

}  // namespace

std::vector<CellSortie> sorties_of(CellRange share, const planner::Returns& returns,
                                   std::uint32_t station) {
  std::vector<CellSortie> list;
  if (share.count == 0) return list;
  std::uint32_t first = share.first;
  const auto add = [&](std::uint32_t stop) {
    list.push_back({.cells = {first, stop - first}, .station = station});
    first = stop;
  };
  for (const std::uint32_t last : returns) add(share.first + last + 1);
  add(end(share));
  return list;
}

SortieLists cell_sorties(const planner::Route& route, const fleet::FleetProblem& model,
                         const fleet::FleetSorties& sorties) {
  std::vector<std::size_t> order;
  const std::vector<fleet::Sortie> sorted = along(sorties, order);
  std::vector<CellRange> cells(sorties.size(), CellRange{0, 0});
  const auto all = static_cast<std::uint32_t>(route.centers.size());
  std::uint32_t first = 0;
  std::optional<std::size_t> before;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const bool is_last = k + 1 == sorted.size();
    const std::uint32_t stop = is_last ? all : stop_of(route, model, sorted[k], first);
    if (stop < first + least_cells) {
      if (is_last && before) cells[*before].count = all - cells[*before].first;
      if (!is_last || before) continue;
    }
    cells[order[k]] = {first, stop - first};
    first = stop;
    before = order[k];
  }
  SortieLists lists(model.fliers.size());
  for (std::size_t i = 0; i < sorties.size(); ++i) {
    if (cells[i].count == 0) continue;
    lists[sorties[i].flier].push_back({.cells = cells[i], .station = sorties[i].depot});
  }
  return lists;
}

fleet::FleetSorties model_sorties(const planner::Route& route, const fleet::FleetProblem& model,
                                  const SortieLists& lists) {
  fleet::FleetSorties sorties;
  for (std::uint32_t u = 0; u < lists.size(); ++u) {
    for (const CellSortie& s : lists[u]) {
      sorties.push_back({.from_m = position_m(route, model.path, s.cells.first),
                         .to_m = position_m(route, model.path, end(s.cells)),
                         .flier = u,
                         .depot = s.station});
    }
  }
  return sorties;
}

std::optional<FlownLists> flown_lists(const planner::Route& whole, const RouteLengths& lengths,
                                      std::span<const Vehicle> vehicles,
                                      std::span<const Station> stations, const SortieLists& lists,
                                      std::span<const double> ready_s) {
  require(lists.size() == vehicles.size(), "every aircraft has a list");
  FlownRoute flown = flown_route(whole, lists);
  FlownLists result;
  Desk desk{flown, lengths, stations};
  for (std::size_t u = 0; u < vehicles.size(); ++u) {
    auto uav = desk.plan(vehicles[u], lists[u], flown.shares[u]);
    if (!uav) return std::nullopt;
    result.uavs.push_back(std::move(*uav));
    result.itineraries.push_back(desk.itinerary());
    result.itineraries.back().begins_s =
        ready_s.empty() ? vehicles[u].available_from.base() : ready_s[u];
  }
  result.forecast = forecast(result.itineraries, stations);
  for (std::size_t u = 0; u < vehicles.size(); ++u) {
    result.uavs[u].visits = result.forecast.visits[u];
    result.uavs[u].spray_ends_s = result.forecast.spray_ends_s[u];
    result.uavs[u].lands_s = result.forecast.lands_s[u];
  }
  result.order = std::move(flown.order);
  return result;
}

std::optional<JointPlan> joint_plan(const planner::Route& route, const RouteLengths& lengths,
                                    std::span<const Vehicle> vehicles,
                                    std::span<const Station> stations,
                                    const planner::SolveSettings& settings,
                                    const SortieLists& start, std::span<const double> ready_s,
                                    Length near, std::size_t threads) {
  JointPlan plan{.flown = {}, .evaluations = 0, .till_empty_s = {}, .simple_s = {}};
  Judge judge{route, lengths, vehicles, stations, ready_s, near, threads};
  ModelMargins margins;
  const bool is_begun =
      std::any_of(start.begin(), start.end(), [](const auto& list) { return !list.empty(); });
  if (is_begun) {
    if (const auto begun = flown_lists(route, lengths, vehicles, stations, start, ready_s)) {
      margins.losses = flight_losses(*begun);
    }
    judge.consider(start);
  }
  for (int attempt = 0; attempt < attempts; ++attempt) {
    auto model = search_model(route, vehicles, stations, margins);
    if (!model) break;
    for (std::size_t u = 0; u < ready_s.size(); ++u) model->fliers[u].ready_s = ready_s[u];
    if (!plan.till_empty_s) plan.till_empty_s = judge.consider(*model, fleet::till_empty(*model));
    if (!plan.simple_s) plan.simple_s = judge.consider(*model, fleet::simple_sorties(*model));
    if (judge.consider_searched(*model, settings, model_sorties(route, *model, start))) break;
    margins.pack_share *= 0.9;
    margins.spare_cells += 2.0;
    margins.early_s += 20.0;
  }
  judge.even_out(settings);
  plan.evaluations = judge.evaluations();
  if (!judge.best()) return std::nullopt;
  plan.flown = std::move(*judge.best());
  return plan;
}

}  // namespace furrow::scheduler
