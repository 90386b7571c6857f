#include "planner/fleet/till_empty.hpp"

#include "planner/fleet/queue_clock.hpp"

#include <algorithm>
#include <limits>

namespace furrow::planner::fleet {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::uint32_t nearest_depot(const FleetProblem& problem, double at_m) {
  const auto nearer = [&](const Depot& a, const Depot& b) {
    return problem.path.back_m(a.position, at_m) < problem.path.back_m(b.position, at_m);
  };
  const auto best = std::min_element(problem.depots.begin(), problem.depots.end(), nearer);
  return static_cast<std::uint32_t>(best - problem.depots.begin());
}

/// Where everybody is and which bays are taken, while the path is dealt out.
struct Ready {
  double lands_s = 0.0;
  std::uint32_t depot = 0;
  bool flew = false;
};

/// Whoever waits longest is served first; the bays are taken in that order.
class Dealer {
 public:
  explicit Dealer(const FleetProblem& problem) : problem_{problem}, ready_(problem.fliers.size()) {
    for (const Depot& d : problem.depots) free_s_.emplace_back(d.bays, 0.0);
    for (std::size_t u = 0; u < ready_.size(); ++u) ready_[u].lands_s = problem.fliers[u].ready_s;
  }

  std::uint32_t next() const {
    const auto first =
        std::min_element(ready_.begin(), ready_.end(),
                         [](const Ready& a, const Ready& b) { return a.lands_s < b.lands_s; });
    return static_cast<std::uint32_t>(first - ready_.begin());
  }
  FieldPoint place(std::uint32_t u) const {
    return ready_[u].flew ? problem_.depots[ready_[u].depot].position : problem_.fliers[u].start;
  }
  double lands_s(const Sortie& s) const {
    return leaves_s(s) + flight_s(problem_, s, place(s.flier));
  }
  void give(const Sortie& s) {
    Ready& r = ready_[s.flier];
    const double lands = lands_s(s);
    if (r.flew) {
      auto& bays = free_s_[r.depot];
      *std::min_element(bays.begin(), bays.end()) = leaves_s(s);
    }
    r = {lands, s.depot, true};
  }
  void rest(std::uint32_t u) { ready_[u].lands_s = infinite; }
  bool all_rest() const { return ready_[next()].lands_s == infinite; }

 private:
  /// The station, once it has been served there.
  double leaves_s(const Sortie& s) const {
    const Ready& r = ready_[s.flier];
    if (!r.flew) return r.lands_s;
    const auto& bays = free_s_[r.depot];
    const double bay_s = *std::min_element(bays.begin(), bays.end());
    return std::max(bay_s, r.lands_s) + service_s(problem_, r.depot, s);
  }

  const FleetProblem& problem_;
  std::vector<Ready> ready_;
  std::vector<std::vector<double>> free_s_;
};

/// The furthest of what `is_carried` holds for, up to `to_m`; it holds near `from_m`, if anywhere.
template <class Question>
double furthest_m(double from_m, double to_m, Question is_carried) {
  if (is_carried(to_m)) return to_m;
  double low_m = from_m, high_m = to_m;
  for (int i = 0; i < 50; ++i) {
    const double middle_m = 0.5 * (low_m + high_m);
    (middle_m > from_m && is_carried(middle_m) ? low_m : high_m) = middle_m;
  }
  return low_m;
}

}  // namespace

double reach_m(const FleetProblem& problem, std::uint32_t flier, FieldPoint out_from, double from_m,
               std::uint32_t depot) {
  const double tank_end_m =
      std::min(problem.path.length_m(), from_m + problem.fliers[flier].tank_m);
  return furthest_m(from_m, tank_end_m, [&](double to_m) {
    return flight_s(problem, {from_m, to_m, flier, depot}, out_from) <=
           problem.fliers[flier].pack_s;
  });
}

std::optional<FleetSorties> dealt_out(const FleetProblem& problem,
                                      const std::function<double(double)>& end_m) {
  constexpr double least_m = 1e-6;
  FleetSorties sorties;
  Dealer dealer{problem};
  for (double from_m = 0.0; from_m < problem.path.length_m() - least_m;) {
    if (dealer.all_rest()) return std::nullopt;
    const std::uint32_t u = dealer.next();
    double to_m = std::min({problem.path.length_m(), from_m + problem.fliers[u].tank_m,
                            std::max(end_m(from_m), from_m + least_m)});
    const std::uint32_t depot = nearest_depot(problem, to_m);
    to_m = std::min(to_m, reach_m(problem, u, dealer.place(u), from_m, depot));
    to_m = furthest_m(from_m, to_m, [&](double sprayed_m) {
      return dealer.lands_s({from_m, sprayed_m, u, depot}) <= problem.fliers[u].until_s;
    });
    if (to_m < from_m + least_m) {
      dealer.rest(u);
      continue;
    }
    sorties.push_back({from_m, to_m, u, depot});
    dealer.give(sorties.back());
    from_m = to_m;
  }
  return sorties;
}

std::optional<FleetSorties> till_empty(const FleetProblem& problem) {
  return dealt_out(problem, [&](double) { return problem.path.length_m(); });
}

std::optional<FleetSorties> simple_sorties(const FleetProblem& problem) {
  double tank_m = infinite;
  for (const Flier& f : problem.fliers) tank_m = std::min(tank_m, f.tank_m);
  const auto nearest_m = [&](std::uint32_t strip, bool begin) {
    double least_m = infinite;
    const double at_m = problem.path.begin_m(strip + (begin ? 0 : 1));
    for (const Depot& d : problem.depots) {
      const double away_m =
          begin ? problem.path.out_m(d.position, at_m) : problem.path.back_m(d.position, at_m);
      least_m = std::min(least_m, away_m);
    }
    return least_m;
  };
  return dealt_out(problem, [&](double from_m) {
    double end_m = from_m + tank_m;
    if (end_m >= problem.path.length_m()) return problem.path.length_m();
    for (std::uint32_t s = problem.path.strip_from(from_m);
         s < problem.path.strips() && problem.path.begin_m(s + 1) <= from_m + tank_m; ++s) {
      if (nearest_m(s, false) <= nearest_m(s, true)) end_m = problem.path.begin_m(s + 1);
    }
    return end_m;
  });
}

}  // namespace furrow::planner::fleet
