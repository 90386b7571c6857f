#include "planner/fleet/queue_clock.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
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
  const double lost_s = flier.sortie_s + flier.hop_s * problem.path.hops(s.from_m, s.to_m);
  return lost_s + (s.to_m - s.from_m) / flier.spray_mps + ferried_m / flier.ferry_mps;
}

double service_s(const FleetProblem& problem, std::uint32_t depot, const Sortie& next, bool swaps) {
  const Depot& at = problem.depots[depot];
  const Flier& flier = problem.fliers[next.flier];
  const double fill_s =
      at.fill_s > 0.0 ? at.fill_s * (next.to_m - next.from_m) / flier.tank_m : 0.0;
  const double filled_s = at.service_s + flier.service_s + fill_s;
  return swaps ? std::max(filled_s, at.swap_s) : filled_s;
}

bool is_better(const Finish& a, const Finish& b) {
  return std::tie(a.late_s, a.makespan_s, a.total_s) < std::tie(b.late_s, b.makespan_s, b.total_s);
}

QueueClock::QueueClock(const FleetProblem& problem) : problem_{problem}, timed_(most_timed) {
  for (const Depot& d : problem.depots) free_s_.emplace_back(d.bays);
}

void QueueClock::arrange(std::span<const Sortie> sorties) {
  const std::size_t fliers = problem_.fliers.size();
  now_.first.assign(fliers + 1, 0);
  for (const Sortie& s : sorties) ++now_.first[s.flier + 1];
  std::partial_sum(now_.first.begin(), now_.first.end(), now_.first.begin());
  now_.sorties.resize(sorties.size());
  number_.resize(sorties.size());
  place_.assign(now_.first.begin(), now_.first.end() - 1);
  for (std::size_t i = 0; i < sorties.size(); ++i) {
    const std::uint32_t place = place_[sorties[i].flier]++;
    now_.sorties[place] = sorties[i];
    number_[place] = static_cast<std::uint32_t>(i);
  }
  leaves_s_.resize(sorties.size());
  lands_s_.resize(sorties.size());
}

// The flier is to be flown, and so are all who meet it in a bay now.
void QueueClock::take(std::size_t flier) {
  is_taken_[flier] = 1;
  for (const Flown* plan : {&now_, &kept_}) {
    const auto sorties = plan->of(flier);
    for (std::size_t k = 0; k + 1 < sorties.size(); ++k) is_busy_[sorties[k].depot] = 1;
  }
}

bool QueueClock::meets_taken(std::size_t flier) const {
  const auto sorties = now_.of(flier);
  return sorties.size() > 1 && std::any_of(sorties.begin(), sorties.end() - 1,
                                           [&](const Sortie& s) { return is_busy_[s.depot] != 0; });
}

// Who flies otherwise than in the plan kept, or meets such aircraft in a bay.
void QueueClock::choose() {
  const std::size_t fliers = problem_.fliers.size();
  const bool is_alone = kept_.first.empty() || problem_.depots.size() == 1;
  is_taken_.assign(fliers, is_alone ? 1 : 0);
  is_busy_.assign(problem_.depots.size(), is_alone ? 1 : 0);
  if (is_alone) return;
  const auto is_same = [](const Sortie& a, const Sortie& b) {
    return a.from_m == b.from_m && a.to_m == b.to_m && a.depot == b.depot;
  };
  for (std::size_t u = 0; u < fliers; ++u) {
    const auto now = now_.of(u), kept = kept_.of(u);
    if (!std::equal(now.begin(), now.end(), kept.begin(), kept.end(), is_same)) take(u);
  }
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t u = 0; u < fliers; ++u) {
      if (is_taken_[u] != 0 || !meets_taken(u)) continue;
      take(u);
      grows = true;
    }
  }
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

/// @return  Whether its pack has to be swapped, and so is full.
bool QueueClock::swap_pack(const Sortie& landed, const Sortie& next) {
  double& used_s = used_s_[next.flier];
  const double after_s = used_s + timed_s(next, landed.depot);
  if (after_s <= problem_.fliers[next.flier].pack_s + slack) return false;
  used_s = 0.0;
  return true;
}

QueueClock::Ended QueueClock::ended(const Sortie& last, const Ended& so_far, double lands_s) const {
  const FieldPoint depot = problem_.depots[last.depot].position;
  const double home_s = problem_.ends_sprayed ? problem_.path.back_m(depot, last.to_m) /
                                                    problem_.fliers[last.flier].ferry_mps
                                              : 0.0;
  return {lands_s, lands_s - home_s, so_far.wait_s, so_far.late_s, so_far.is_carried};
}

void QueueClock::fly(std::uint32_t i, std::uint32_t from_depot, double at_s) {
  const Sortie& s = now_.sorties[i];
  const Flier& flier = problem_.fliers[s.flier];
  const double flight_s = timed_s(s, from_depot);
  Ended& ended = now_.ended[s.flier];
  ended.is_carried &= s.to_m - s.from_m <= flier.tank_m + slack;
  ended.is_carried &= flight_s <= flier.pack_s + slack;
  used_s_[s.flier] += flight_s;
  leaves_s_[i] = at_s;
  lands_s_[i] = at_s + flight_s;
  ++flown_count_;
  arrivals_.push_back({lands_s_[i], s.flier, i});
  std::push_heap(arrivals_.begin(), arrivals_.end(), is_later);
}

void QueueClock::land(const Arrival& now) {
  const Sortie& landed = now_.sorties[now.sortie];
  Ended& ended = now_.ended[now.flier];
  if (now.sortie + 1 == now_.first[now.flier + 1]) {
    ended = this->ended(landed, ended, now.at_s);
    return;
  }
  const Sortie& next = now_.sorties[now.sortie + 1];
  auto& bays = free_s_[landed.depot];
  double& bay_s = *std::min_element(bays.begin(), bays.end());
  const double starts_s = std::max({now.at_s, bay_s, problem_.depots[landed.depot].opens_s});
  ended.wait_s += starts_s - now.at_s;
  bay_s = starts_s + service_s(problem_, landed.depot, next, swap_pack(landed, next));
  ended.late_s += std::max(0.0, bay_s - problem_.depots[landed.depot].closes_s);
  fly(now.sortie + 1, landed.depot, bay_s);
}

Finish QueueClock::sum() const {
  Finish finish{};
  for (std::size_t u = 0; u < problem_.fliers.size(); ++u) {
    const Ended& ended = now_.ended[u];
    finish.makespan_s = std::max(finish.makespan_s, ended.ends_s);
    finish.total_s += ended.lands_s;
    finish.wait_s += ended.wait_s;
    finish.late_s += ended.late_s + std::max(0.0, ended.lands_s - problem_.fliers[u].until_s);
    finish.is_carried &= ended.is_carried;
  }
  return finish;
}

Finish QueueClock::finish(std::span<const Sortie> sorties) {
  arrange(sorties);
  choose();
  for (std::size_t d = 0; d < free_s_.size(); ++d) {
    if (is_busy_[d] != 0) free_s_[d].assign(free_s_[d].size(), problem_.depots[d].opens_s);
  }
  flown_count_ = 0;
  arrivals_.clear();
  now_.ended.resize(problem_.fliers.size());
  used_s_.assign(problem_.fliers.size(), 0.0);
  for (std::size_t u = 0; u < problem_.fliers.size(); ++u) {
    now_.ended[u] = is_taken_[u] != 0 ? Ended{} : kept_.ended[u];
    if (is_taken_[u] == 0 || now_.of(u).empty()) continue;
    fly(now_.first[u], none, problem_.fliers[u].ready_s);
  }
  while (!arrivals_.empty()) {
    const Arrival now = arrivals_.front();
    std::pop_heap(arrivals_.begin(), arrivals_.end(), is_later);
    arrivals_.pop_back();
    land(now);
  }
  return sum();
}

void QueueClock::keep() { std::swap(now_, kept_); }

Timetable QueueClock::timetable(std::span<const Sortie> sorties) {
  kept_ = {};
  const Finish end = finish(sorties);
  double spray_s = 0.0;
  std::vector<double> leaves_s(sorties.size()), lands_s(sorties.size());
  for (std::size_t i = 0; i < sorties.size(); ++i) {
    spray_s += (sorties[i].to_m - sorties[i].from_m) / problem_.fliers[sorties[i].flier].spray_mps;
    leaves_s[number_[i]] = leaves_s_[i];
    lands_s[number_[i]] = lands_s_[i];
  }
  return {.leaves_s = std::move(leaves_s),
          .lands_s = std::move(lands_s),
          .makespan_s = end.makespan_s,
          .non_spray_s = end.total_s - spray_s,
          .wait_s = end.wait_s};
}

}  // namespace furrow::planner::fleet
