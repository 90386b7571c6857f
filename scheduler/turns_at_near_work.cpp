#include "scheduler/turns_at_near_work.hpp"

#include "planner/coverage/plane.hpp"
#include "scheduler/near_strips.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace furrow::scheduler {
namespace {

constexpr double unsure_s = 15.0;
constexpr double worth_it_s = 1.0;
constexpr int most_forecasts = 100;

planner::PointM plane(FieldPoint p) { return {p.x.base(), p.y.base()}; }

/// A strip near to others, of the route in the order flown, and when it is sprayed.
struct Turn {
  std::size_t uav, flight;
  std::size_t strip;  // of the whole route
  planner::PointM from, to;
  double begins_s, ends_s;
};

struct Flight {
  CellRange cells;
  double begins_s, ends_s;
};

std::vector<Flight> flights(const UavPlan& uav, double begins_s) {
  std::vector<Flight> all;
  std::uint32_t first = uav.cells.first;
  const auto add = [&](std::uint32_t stop, double ends_s) {
    all.push_back({{first, stop - first}, begins_s, ends_s});
    first = stop;
  };
  for (std::size_t k = 0; k < uav.visits.size(); ++k) {
    add(uav.cells.first + uav.solution.plan.returns[k] + 1, uav.visits[k].arrives_s);
    begins_s = uav.visits[k].ready_s;
  }
  if (uav.cells.count > 0) add(end(uav.cells), uav.lands_s);
  return all;
}

/// All that flights have of strips near to others.
std::vector<Turn> turns(const FlownLists& flown, const planner::Route& whole, Length near) {
  const planner::Route& route = flown.order.route;
  const std::vector<bool> is_near = strips_near_others(whole, near);
  std::vector<Turn> all;
  for (std::size_t u = 0; u < flown.uavs.size(); ++u) {
    const auto own = flights(flown.uavs[u], flown.itineraries[u].begins_s);
    for (std::size_t k = 0; k < own.size(); ++k) {
      const auto [cells, begins_s, ends_s] = own[k];
      const double cell_s = (ends_s - begins_s) / cells.count;
      for (std::size_t s = planner::strip_of(route, cells.first);
           s < route.strips.size() && route.strips[s].cells.first < end(cells); ++s) {
        const planner::Strip& strip = route.strips[s];
        const std::size_t in_whole = planner::strip_of(whole, flown.order.cells[strip.cells.first]);
        if (!is_near[in_whole]) continue;
        const double comes_s =
            begins_s + cell_s * (std::max(strip.cells.first, cells.first) - cells.first);
        all.push_back({u, k, in_whole, plane(strip.begin), plane(strip.end), comes_s - unsure_s,
                       comes_s + cell_s * strip.cells.count + unsure_s});
      }
    }
  }
  return all;
}

/// How long two aircraft are at the same time on near strips.
double wait_s(const Turn& a, const Turn& b, Length near) {
  const double both_s = std::min(a.ends_s, b.ends_s) - std::max(a.begins_s, b.begins_s);
  const bool is_met = a.uav != b.uav && a.strip != b.strip && both_s > 0.0 &&
                      planner::apart_m(a.from, a.to, b.from, b.to) < near.base();
  return is_met ? both_s : 0.0;
}

/// The flights that wait or are waited for, by aircraft and place in its list.
std::set<std::pair<std::size_t, std::size_t>> waiting(const FlownLists& flown,
                                                      const planner::Route& whole, Length near) {
  std::set<std::pair<std::size_t, std::size_t>> found;
  const std::vector<Turn> all = turns(flown, whole, near);
  for (const Turn& a : all) {
    for (const Turn& b : all) {
      if (wait_s(a, b, near) > 0.0) found.insert({a.uav, a.flight});
    }
  }
  return found;
}

/// The lists in cells of the whole route.
SortieLists lists_of(const FlownLists& flown, std::span<const Station> stations) {
  SortieLists lists(flown.uavs.size());
  for (std::size_t u = 0; u < lists.size(); ++u) {
    const UavPlan& uav = flown.uavs[u];
    for (const Flight& flight : flights(uav, 0.0)) {
      const StationId at = landing(uav, lists[u].size()).id;
      const auto station = std::find_if(stations.begin(), stations.end(),
                                        [at](const Station& s) { return s.id == at; });
      lists[u].push_back({.cells = {flown.order.cells[flight.cells.first], flight.cells.count},
                          .station = static_cast<std::uint32_t>(station - stations.begin())});
    }
  }
  return lists;
}

double loss_s(const FlownLists& flown, const planner::Route& whole, Length near) {
  return flown.forecast.makespan_s + waits_at_near_work_s(flown, whole, near);
}

SortieLists moved(SortieLists lists, std::size_t uav, std::size_t from, std::size_t to) {
  auto& list = lists[uav];
  const CellSortie sortie = list[from];
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(from));
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(to), sortie);
  return lists;
}

}  // namespace

double waits_at_near_work_s(const FlownLists& flown, const planner::Route& whole, Length near) {
  const std::vector<Turn> all = turns(flown, whole, near);
  double sum_s = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) sum_s += wait_s(all[i], all[j], near);
  }
  return sum_s;
}

FlownLists turned_at_near_work(FlownLists flown, const planner::Route& whole,
                               const RouteLengths& lengths, std::span<const Vehicle> vehicles,
                               std::span<const Station> stations, Length near) {
  int forecasts = 0;
  for (bool is_better = true; is_better;) {
    is_better = false;
    const SortieLists lists = lists_of(flown, stations);
    double least_s = loss_s(flown, whole, near) - worth_it_s;
    for (const auto& [u, from] : waiting(flown, whole, near)) {
      for (std::size_t to = 0; to < lists[u].size(); ++to) {
        if (from == to || ++forecasts > most_forecasts) continue;
        auto other = flown_lists(whole, lengths, vehicles, stations, moved(lists, u, from, to));
        if (!other || !other->forecast.is_sure || !is_in_time(vehicles, other->forecast)) continue;
        const double loss = loss_s(*other, whole, near);
        if (loss >= least_s) continue;
        least_s = loss;
        flown = std::move(*other);
        is_better = true;
      }
    }
  }
  return flown;
}

}  // namespace furrow::scheduler
