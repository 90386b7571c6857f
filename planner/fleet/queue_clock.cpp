#include "planner/fleet/queue_clock.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>

namespace furrow::planner::fleet {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr int timed_bits = 13;
constexpr std::size_t most_timed = std::size_t{1} << timed_bits;
constexpr double slack = 1e-9;  // of rounding, in a tank and a pack

std::size_t hash(const Sortie& s, std::uint32_t from_depot) {
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15;
  std::uint64_t mixed = std::bit_cast<std::uint64_t>(s.from_m) * factor;
  mixed = (mixed ^ std::bit_cast<std::uint64_t>(s.to_m)) * factor;
  mixed = (mixed ^ (mixed >> 32) ^ s.flier ^ (std::uint64_t{s.depot} << 20) ^
           (std::uint64_t{from_depot} << 40)) *
          factor;
  return static_cast<std::size_t>(mixed >> (64 - timed_bits));
}

}  // namespace

double flight_s(const FleetProblem& problem, const Sortie& s, FieldPoint from) {
  const Flier& flier = problem.fliers[s.flier];
  const double home_m =
      std::min(problem.most_home_m, problem.path.back_m(problem.depots[s.depot].position, s.to_m));
  const double ferried_m =
      problem.path.out_m(from, s.from_m) + problem.path.hops_m(s.from_m, s.to_m) + home_m;
  return flier.sortie_s + (s.to_m - s.from_m) / flier.spray_mps + ferried_m / flier.ferry_mps;
}

double service_s(const FleetProblem& problem, std::uint32_t depot, const Sortie& next) {
  const Depot& at = problem.depots[depot];
  const Flier& flier = problem.fliers[next.flier];
  const double fill_s =
      at.fill_s > 0.0 ? at.fill_s * (next.to_m - next.from_m) / flier.tank_m : 0.0;
  return at.service_s + flier.service_s + fill_s;
}

bool is_better(const Finish& a, const Finish& b) {
  return std::tie(a.late_s, a.makespan_s, a.total_s) < std::tie(b.late_s, b.makespan_s, b.total_s);
}

QueueClock::QueueClock(const FleetProblem& problem) : problem_{problem}, timed_(most_timed) {
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

/// @param from_depot  None: from the flier's start.
double QueueClock::timed_s(const Sortie& s, std::uint32_t from_depot) {
  Timed& known = timed_[hash(s, from_depot)];
  if (known.from_m == s.from_m && known.to_m == s.to_m && known.flier == s.flier &&
      known.depot == s.depot && known.from_depot == from_depot)
    return known.flight_s;
  const FieldPoint from =
      from_depot == none ? problem_.fliers[s.flier].start : problem_.depots[from_depot].position;
  known = {s.from_m, s.to_m, s.flier, s.depot, from_depot, flight_s(problem_, s, from)};
  return known.flight_s;
}

/// When the bay lets it go, having waited for it.
double QueueClock::served_s(const Sortie& landed, const Sortie& next, double arrives_s) {
  auto& bays = free_s_[landed.depot];
  double& bay = *std::min_element(bays.begin(), bays.end());
  bay = std::max(arrives_s, bay) + service_s(problem_, landed.depot, next);
  return bay;
}

void QueueClock::end(const Arrival& last, const Sortie& landed, Finish& finish) const {
  const Flier& flier = problem_.fliers[last.flier];
  const FieldPoint depot = problem_.depots[landed.depot].position;
  const double home_s =
      problem_.ends_sprayed ? problem_.path.back_m(depot, landed.to_m) / flier.ferry_mps : 0.0;
  finish.makespan_s = std::max(finish.makespan_s, last.at_s - home_s);
  finish.total_s += last.at_s;
  finish.late_s += std::max(0.0, last.at_s - flier.until_s);
}

Finish QueueClock::finish(std::span<const Sortie> sorties) {
  link(sorties);
  const auto later = [](const Arrival& a, const Arrival& b) {
    return a.at_s != b.at_s ? a.at_s > b.at_s : a.flier > b.flier;
  };
  Finish finish{};
  const auto fly = [&](std::uint32_t i, std::uint32_t from_depot, double at_s) {
    const Sortie& s = sorties[i];
    const Flier& flier = problem_.fliers[s.flier];
    const double flight_s = timed_s(s, from_depot);
    finish.is_carried &= s.to_m - s.from_m <= flier.tank_m + slack;
    finish.is_carried &= flight_s <= flier.pack_s + slack;
    leaves_s_[i] = at_s;
    lands_s_[i] = at_s + flight_s;
    arrivals_.push_back({lands_s_[i], sorties[i].flier, i});
    std::push_heap(arrivals_.begin(), arrivals_.end(), later);
  };
  arrivals_.clear();
  for (std::size_t u = 0; u < first_.size(); ++u) {
    if (first_[u] != none) fly(first_[u], none, problem_.fliers[u].ready_s);
  }
  while (!arrivals_.empty()) {
    const Arrival now = arrivals_.front();
    std::pop_heap(arrivals_.begin(), arrivals_.end(), later);
    arrivals_.pop_back();
    const Sortie& landed = sorties[now.sortie];
    if (next_[now.sortie] == none) {
      end(now, landed, finish);
      continue;
    }
    const Sortie& next = sorties[next_[now.sortie]];
    const double leaves_s = served_s(landed, next, now.at_s);
    finish.wait_s += leaves_s - service_s(problem_, landed.depot, next) - now.at_s;
    fly(next_[now.sortie], landed.depot, leaves_s);
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
