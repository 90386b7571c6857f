#include "scheduler/forecast.hpp"

#include "core/require.hpp"
#include "planner/returns/evaluate.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>

namespace furrow::scheduler {
namespace {

/// The bay for one who comes at `arrives_s`: the lowest free one, else the one that is free first.
std::size_t bay_for(double arrives_s, const std::vector<double>& free_s) {
  const auto idle = std::find_if(free_s.begin(), free_s.end(),
                                 [arrives_s](double free) { return free <= arrives_s; });
  const auto bay = idle != free_s.end() ? idle : std::min_element(free_s.begin(), free_s.end());
  return static_cast<std::size_t>(bay - free_s.begin());
}

struct Arrival {
  double at_s;
  std::size_t who;
};

/// Of two who come at once, the earlier in the list is served first.
bool is_later(const Arrival& a, const Arrival& b) {
  return a.at_s != b.at_s ? a.at_s > b.at_s : a.who > b.who;
}

/// Serves the visits of `itineraries` in order of arrival. `bays(i, n)` gives the bays that visit n
/// of itinerary i may use, by when they are free; `leaves(i, n, ready_s)` says when one that is
/// ready for flight n takes off; `served(i, visit)` hears of each. A later arrival never changes an
/// earlier service, so one pass is enough.
template <class Bays, class Leaves, class Served>
void serve(std::span<const Itinerary> itineraries, Bays bays, Leaves leaves, Served served) {
  std::vector<Arrival> arrivals;
  std::vector<std::size_t> next(itineraries.size(), 0);
  const auto arrive = [&](std::size_t i, double ready_s) {
    if (!itineraries[i].flies) return;
    const double leaves_s = leaves(i, next[i], ready_s);
    if (next[i] >= itineraries[i].flights_s.size()) return;
    arrivals.push_back({leaves_s + itineraries[i].flights_s[next[i]], i});
    std::push_heap(arrivals.begin(), arrivals.end(), is_later);
  };
  for (std::size_t i = 0; i < itineraries.size(); ++i) arrive(i, itineraries[i].begins_s);
  while (!arrivals.empty()) {
    const auto [at_s, i] = arrivals.front();
    std::pop_heap(arrivals.begin(), arrivals.end(), is_later);
    arrivals.pop_back();
    std::vector<double>& free_s = bays(i, next[i]);
    const std::size_t bay = bay_for(at_s, free_s);
    const double starts_s = std::max(at_s, free_s[bay]);
    const double ready_s = starts_s + itineraries[i].services_s[next[i]];
    served(i, Visit{at_s, starts_s, ready_s, static_cast<std::uint32_t>(bay + 1)});
    free_s[bay] = ready_s;
    ++next[i];
    arrive(i, ready_s);
  }
}

double as_ready(std::size_t, std::size_t, double ready_s) { return ready_s; }

/// When aircraft take off from each pad.
class TakeOffs {
 public:
  TakeOffs(std::span<const Itinerary> itineraries, const Pads& pads)
      : itineraries_{itineraries}, pads_{pads}, left_s_(itineraries.size(), 0.0) {}

  double operator()(std::size_t i, std::size_t flight, double ready_s) {
    return left_s_[i] = pads_.slot_s > 0.0 ? first_free_s(pad(i, flight), ready_s) : ready_s;
  }
  /// The last of an itinerary.
  double left_s(std::size_t i) const { return left_s_[i]; }

 private:
  std::uint32_t pad(std::size_t i, std::size_t flight) const {
    return flight == 0 ? pads_.homes[i] : pads_.stations[itineraries_[i].stations[flight - 1]];
  }
  /// Takes the first slot from `ready_s` on that is nobody's.
  double first_free_s(std::uint32_t pad, double ready_s) {
    std::set<double>& taken = taken_[pad];
    double at_s = ready_s;
    for (auto other = taken.upper_bound(ready_s - pads_.slot_s); other != taken.end(); ++other) {
      if (*other >= at_s + pads_.slot_s) break;
      at_s = *other + pads_.slot_s;
    }
    taken.insert(at_s);
    return at_s;
  }

  std::span<const Itinerary> itineraries_;
  const Pads& pads_;
  std::vector<double> left_s_;
  std::map<std::uint32_t, std::set<double>> taken_{};
};

}  // namespace

Itinerary grounded(AgentId agent) {
  return {.agent = agent,
          .flights_s = {},
          .services_s = {},
          .stations = {},
          .last_spray_s = 0,
          .last_home_s = 0,
          .flies = false};
}

Itinerary itinerary(AgentId agent, std::uint32_t station, const planner::ReturnPlan& plan,
                    const FlightTimes& times) {
  Itinerary it = itinerary(agent, std::vector(plan.sorties.size(), 0U), plan, times);
  it.stations.assign(it.stations.size(), station);
  return it;
}

Itinerary itinerary(AgentId agent, std::span<const std::uint32_t> landings,
                    const planner::ReturnPlan& plan, const FlightTimes& times) {
  Itinerary it = grounded(agent);
  it.flies = true;
  for (std::size_t n = 0; n < plan.sorties.size(); ++n) {
    const FlightTimes::Ends ends{.from = landings[n == 0 ? 0 : n - 1], .to = landings[n]};
    const SortieTimes flown = times(plan.sorties[n], n == 0, ends);
    if (n + 1 < plan.sorties.size()) {
      it.flights_s.push_back(flown.until_sprayed_s + flown.home_s);
      it.services_s.push_back(plan.sorties[n].service_s);
      it.stations.push_back(landings[n]);
    } else {
      it.last_spray_s = flown.until_sprayed_s;
      it.last_home_s = flown.home_s;
    }
  }
  return it;
}

void swap_as_flown(std::span<const planner::ReturnProblem* const> landings,
                   planner::ReturnPlan& plan, Itinerary& itinerary) {
  if (landings.front()->hills) return;
  std::vector<double> lost_s;
  for (std::size_t n = 0; n < plan.sorties.size(); ++n) {
    const planner::PlannedSortie& s = plan.sorties[n];
    const bool is_last = n == itinerary.flights_s.size();
    const double flown_s =
        is_last ? itinerary.last_spray_s + itinerary.last_home_s : itinerary.flights_s[n];
    lost_s.push_back(flown_s - (s.fly_out_s + s.spray_s + s.fly_back_s));
  }
  plan = planner::evaluated_as_flown(landings, plan.returns, lost_s);
  const Vehicle& vehicle = landings.front()->vehicle;
  itinerary.is_sure =
      std::all_of(plan.sorties.begin(), plan.sorties.end(), [&](const planner::PlannedSortie& s) {
        return s.battery_used * vehicle.flight_endurance.base() <= longest_flight_s(vehicle);
      });
  for (std::size_t n = 0; n < itinerary.services_s.size(); ++n) {
    itinerary.services_s[n] = plan.sorties[n].service_s;
  }
}

bool is_in_time(const Vehicle& vehicle, double lands_s) {
  const auto until = planned_until(vehicle);
  return !until || lands_s <= until->base();
}

bool is_in_time(std::span<const Vehicle> fleet, const Forecast& forecast) {
  if (forecast.late_s > 0.0) return false;
  for (std::size_t u = 0; u < fleet.size(); ++u) {
    if (!is_in_time(fleet[u], forecast.lands_s[u])) return false;
  }
  return true;
}

std::tuple<double, double> worth(std::span<const double> spray_ends_s) {
  double makespan_s = 0.0;
  for (const double s : spray_ends_s) makespan_s = std::max(makespan_s, s);
  return {makespan_s, std::accumulate(spray_ends_s.begin(), spray_ends_s.end(), 0.0)};
}

std::tuple<double, double> worth(const Forecast& f) { return worth(f.spray_ends_s); }

Forecast forecast(std::span<const Itinerary> itineraries, std::span<const Station> stations,
                  const Pads& pads) {
  const std::size_t count = itineraries.size();
  Forecast f;
  f.is_sure = std::all_of(itineraries.begin(), itineraries.end(),
                          [](const Itinerary& it) { return it.is_sure; });
  f.visits.resize(count);
  f.spray_ends_s.assign(count, 0.0);
  f.lands_s.assign(count, 0.0);
  std::vector<std::vector<double>> free_s;
  free_s.reserve(stations.size());
  for (const Station& s : stations) free_s.emplace_back(s.bays, s.available_from.base());
  TakeOffs take_offs{itineraries, pads};
  serve(
      itineraries,
      [&](std::size_t i, std::size_t n) -> auto& { return free_s[itineraries[i].stations[n]]; },
      std::ref(take_offs),
      [&](std::size_t i, const Visit& visit) {
        const Station& at = stations[itineraries[i].stations[f.visits[i].size()]];
        if (const auto until = planned_until(at)) {
          f.late_s += std::max(0.0, visit.ready_s - until->base());
        }
        f.visits[i].push_back(visit);
        f.queue_wait_s += visit.starts_s - visit.arrives_s;
      });
  for (std::size_t i = 0; i < count; ++i) {
    const Itinerary& it = itineraries[i];
    if (!it.flies) continue;
    f.spray_ends_s[i] = take_offs.left_s(i) + it.last_spray_s;
    f.lands_s[i] = f.spray_ends_s[i] + it.last_home_s;
    f.makespan_s = std::max(f.makespan_s, f.spray_ends_s[i]);
  }
  return f;
}

FleetEnds::FleetEnds(std::vector<Itinerary> itineraries, std::span<const Station> stations)
    : itineraries_{std::move(itineraries)},
      stations_{stations},
      ends_s_{forecast(itineraries_, stations_).spray_ends_s} {}

std::vector<double> FleetEnds::with(std::size_t index, const Itinerary& other) const {
  const auto meets = [](const Itinerary& a, const Itinerary& b) {
    return !a.stations.empty() && !b.stations.empty() && a.stations[0] == b.stations[0];
  };
  std::vector<std::size_t> who;
  std::vector<Itinerary> queued;
  for (std::size_t i = 0; i < itineraries_.size(); ++i) {
    if (i != index && !meets(itineraries_[i], itineraries_[index]) &&
        !meets(itineraries_[i], other))
      continue;
    who.push_back(i);
    queued.push_back(i == index ? other : itineraries_[i]);
  }
  const Forecast again = forecast(queued, stations_);
  std::vector<double> ends_s = ends_s_;
  for (std::size_t i = 0; i < who.size(); ++i) ends_s[who[i]] = again.spray_ends_s[i];
  return ends_s;
}

void FleetEnds::change(std::size_t index, Itinerary other) {
  ends_s_ = with(index, other);
  itineraries_[index] = std::move(other);
}

QueueClock::QueueClock(const Station& station, std::vector<Itinerary> itineraries)
    : itineraries_{std::move(itineraries)},
      opens_s_{station.available_from.base()},
      free_s_(station.bays, opens_s_) {
  require(station.bays >= 1, "a station has a bay");
}

double QueueClock::queue_wait_s(std::size_t index, Itinerary other) {
  itineraries_[index] = std::move(other);
  double wait_s = 0.0;
  free_s_.assign(free_s_.size(), opens_s_);
  serve(
      itineraries_, [&](std::size_t, std::size_t) -> auto& { return free_s_; }, as_ready,
      [&](std::size_t, const Visit& v) { wait_s += v.starts_s - v.arrives_s; });
  return wait_s;
}

double QueueClock::queue_wait_without_s(std::size_t index) {
  return queue_wait_s(index, grounded(itineraries_[index].agent));
}

}  // namespace furrow::scheduler
