#include "planner/fleet/queue_clock.hpp"

#include <algorithm>
#include <limits>

namespace furrow::planner::fleet {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

double flight_s(const FleetProblem& problem, const Sortie& s, FieldPoint from) {
  const Flier& flier = problem.fliers[s.flier];
  const double ferried_m = problem.path.out_m(from, s.from_m) +
                           problem.path.hops_m(s.from_m, s.to_m) +
                           problem.path.back_m(problem.depots[s.depot].position, s.to_m);
  return (s.to_m - s.from_m) / flier.spray_mps + ferried_m / flier.ferry_mps;
}

QueueClock::QueueClock(const FleetProblem& problem) : problem_{problem} {
  for (const Depot& d : problem.depots) free_s_.emplace_back(d.bays);
}

void QueueClock::link(std::span<const Sortie> sorties) {
  first_.assign(problem_.fliers.size(), none);
  next_.assign(sorties.size(), none);
  for (std::size_t i = sorties.size(); i-- > 0;) {
    next_[i] = first_[sorties[i].flier];
    first_[sorties[i].flier] = static_cast<std::uint32_t>(i);
  }
  leaves_s_.resize(sorties.size());
  lands_s_.resize(sorties.size());
  for (auto& bays : free_s_) bays.assign(bays.size(), 0.0);
}

double QueueClock::service_start_s(const Sortie& landed, double arrives_s) {
  auto& bays = free_s_[landed.depot];
  double& bay = *std::min_element(bays.begin(), bays.end());
  const double starts_s = std::max(arrives_s, bay);
  bay =
      starts_s + problem_.depots[landed.depot].service_s + problem_.fliers[landed.flier].service_s;
  return starts_s;
}

Finish QueueClock::finish(std::span<const Sortie> sorties) {
  link(sorties);
  const auto later = [](const Arrival& a, const Arrival& b) {
    return a.at_s != b.at_s ? a.at_s > b.at_s : a.flier > b.flier;
  };
  const auto fly = [&](std::uint32_t i, FieldPoint from, double at_s) {
    leaves_s_[i] = at_s;
    lands_s_[i] = at_s + flight_s(problem_, sorties[i], from);
    arrivals_.push_back({lands_s_[i], sorties[i].flier, i});
    std::push_heap(arrivals_.begin(), arrivals_.end(), later);
  };
  arrivals_.clear();
  for (std::size_t u = 0; u < first_.size(); ++u) {
    if (first_[u] != none) fly(first_[u], problem_.fliers[u].start, 0.0);
  }
  Finish finish{};
  while (!arrivals_.empty()) {
    const Arrival now = arrivals_.front();
    std::pop_heap(arrivals_.begin(), arrivals_.end(), later);
    arrivals_.pop_back();
    if (next_[now.sortie] == none) {
      finish.makespan_s = std::max(finish.makespan_s, now.at_s);
      finish.total_s += now.at_s;
      continue;
    }
    const Sortie& landed = sorties[now.sortie];
    const Depot& depot = problem_.depots[landed.depot];
    const double starts_s = service_start_s(landed, now.at_s);
    finish.wait_s += starts_s - now.at_s;
    const double service_s = depot.service_s + problem_.fliers[now.flier].service_s;
    fly(next_[now.sortie], depot.position, starts_s + service_s);
  }
  return finish;
}

Timetable QueueClock::timetable(std::span<const Sortie> sorties) {
  const Finish end = finish(sorties);
  double spray_s = 0.0;
  for (const Sortie& s : sorties)
    spray_s += (s.to_m - s.from_m) / problem_.fliers[s.flier].spray_mps;
  return {.leaves_s = leaves_s_,
          .lands_s = lands_s_,
          .makespan_s = end.makespan_s,
          .non_spray_s = end.total_s - spray_s,
          .wait_s = end.wait_s};
}

}  // namespace furrow::planner::fleet
