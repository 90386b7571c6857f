#include "scheduler/forecast.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <limits>

namespace furrow::scheduler {
namespace {

constexpr double over = std::numeric_limits<double>::infinity();

void fill(Itinerary& it, const planner::ReturnPlan& plan) {
  it.flights_s.clear();
  it.services_s.clear();
  it.flies = !plan.sorties.empty();
  if (!it.flies) return;
  for (std::size_t n = 0; n + 1 < plan.sorties.size(); ++n) {
    const planner::PlannedSortie& s = plan.sorties[n];
    it.flights_s.push_back(s.fly_out_s + s.spray_s + s.fly_back_s);
    it.services_s.push_back(s.service_s);
  }
  const planner::PlannedSortie& last = plan.sorties.back();
  it.last_spray_s = last.fly_out_s + last.spray_s;
  it.last_home_s = last.fly_back_s;
}

/// The bay for one who comes at `arrives_s`: the lowest free one, else the one that is free first.
std::size_t bay_for(double arrives_s, const std::vector<double>& free_s) {
  const auto idle = std::find_if(free_s.begin(), free_s.end(),
                                 [arrives_s](double free) { return free <= arrives_s; });
  const auto bay = idle != free_s.end() ? idle : std::min_element(free_s.begin(), free_s.end());
  return static_cast<std::size_t>(bay - free_s.begin());
}

/// Serves the visits of `itineraries` in order of arrival. `served(i, visit)` hears of each; the
/// vectors are scratch. A later arrival never changes an earlier service, so one pass is enough.
template <class Served>
void serve(const std::vector<const Itinerary*>& itineraries, std::uint32_t bays,
           std::vector<double>& arrives_s, std::vector<double>& free_s,
           std::vector<std::size_t>& next, Served served) {
  const std::size_t count = itineraries.size();
  free_s.assign(bays, 0.0);
  next.assign(count, 0);
  arrives_s.assign(count, over);
  for (std::size_t i = 0; i < count; ++i) {
    if (!itineraries[i]->flights_s.empty()) arrives_s[i] = itineraries[i]->flights_s[0];
  }
  for (;;) {
    const auto first = std::min_element(arrives_s.begin(), arrives_s.end());
    if (first == arrives_s.end() || *first == over) return;
    const auto i = static_cast<std::size_t>(first - arrives_s.begin());
    const Itinerary& it = *itineraries[i];
    const std::size_t bay = bay_for(*first, free_s);
    const double starts_s = std::max(*first, free_s[bay]);
    const double ready_s = starts_s + it.services_s[next[i]];
    served(i, Visit{*first, starts_s, ready_s, static_cast<std::uint32_t>(bay + 1)});
    free_s[bay] = ready_s;
    ++next[i];
    *first = next[i] < it.flights_s.size() ? ready_s + it.flights_s[next[i]] : over;
  }
}

}  // namespace

Itinerary itinerary(AgentId agent, std::uint32_t station, const planner::ReturnPlan& plan) {
  Itinerary it{.agent = agent,
               .station = station,
               .flights_s = {},
               .services_s = {},
               .last_spray_s = 0,
               .last_home_s = 0,
               .flies = false};
  fill(it, plan);
  return it;
}

Forecast forecast(std::span<const Itinerary> itineraries, std::span<const Station> stations) {
  const std::size_t count = itineraries.size();
  Forecast f;
  f.visits.resize(count);
  f.spray_ends_s.assign(count, 0.0);
  f.lands_s.assign(count, 0.0);
  std::vector<double> arrives_s, free_s;
  std::vector<std::size_t> next;
  for (std::size_t s = 0; s < stations.size(); ++s) {
    std::vector<const Itinerary*> here;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < count; ++i) {
      if (itineraries[i].station != s) continue;
      here.push_back(&itineraries[i]);
      index.push_back(i);
    }
    serve(here, stations[s].bays, arrives_s, free_s, next, [&](std::size_t i, const Visit& visit) {
      f.visits[index[i]].push_back(visit);
      f.queue_wait_s += visit.starts_s - visit.arrives_s;
    });
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Itinerary& it = itineraries[i];
    if (!it.flies) continue;
    const double leaves_s = f.visits[i].empty() ? 0.0 : f.visits[i].back().ready_s;
    f.spray_ends_s[i] = leaves_s + it.last_spray_s;
    f.lands_s[i] = f.spray_ends_s[i] + it.last_home_s;
    f.makespan_s = std::max(f.makespan_s, f.spray_ends_s[i]);
  }
  return f;
}

QueueClock::QueueClock(std::uint32_t bays, std::vector<Itinerary> itineraries)
    : itineraries_{std::move(itineraries)}, free_s_(bays, 0.0) {
  require(bays >= 1, "a station has a bay");
}

double QueueClock::run() {
  std::vector<const Itinerary*> all;
  for (const Itinerary& it : itineraries_) all.push_back(&it);
  double wait_s = 0.0;
  serve(all, static_cast<std::uint32_t>(free_s_.size()), arrives_s_, free_s_, next_,
        [&](std::size_t, const Visit& v) { wait_s += v.starts_s - v.arrives_s; });
  return wait_s;
}

double QueueClock::queue_wait_s(std::size_t index, const planner::ReturnPlan& plan) {
  fill(itineraries_[index], plan);
  return run();
}

double QueueClock::queue_wait_without_s(std::size_t index) {
  return queue_wait_s(index, planner::ReturnPlan{});
}

}  // namespace furrow::scheduler
