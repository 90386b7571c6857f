#pragma once
// Small fleet problems whose plans can all be listed: what bounds and searches are judged by.

#include "core/random.hpp"
#include "planner/fleet/queue_clock.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace furrow::planner::fleet::enumerated {

/// One to three aircraft that may differ, one or two stations, two or three strips.
inline FleetProblem random_problem(std::uint64_t seed) {
  Random random{seed};
  const auto place = [&] { return at_m(random.uniform(-20, 60), random.uniform(-20, 20)); };
  const std::uint64_t rows = 2 + random.below(2), depots = 1 + random.below(2);
  const std::uint64_t fliers = 1 + random.below(3);
  const bool alike = random.below(2) == 0;
  std::vector<StraightStrip> strips;
  for (std::uint64_t row = 0; row < rows; ++row) {
    const double y_m = 3.0 * static_cast<double>(row);
    strips.push_back({at_m(random.uniform(0, 5), y_m), at_m(random.uniform(35, 40), y_m)});
    if (row % 2 == 1) std::swap(strips.back().begin, strips.back().end);
  }
  FleetProblem p{StripPath{strips}, {}, {}};
  for (std::uint64_t d = 0; d < depots; ++d) {
    const auto bays = static_cast<std::uint32_t>(1 + random.below(2));
    p.depots.push_back({place(), bays, random.below(4) == 0 ? 0.0 : random.uniform(0, 40)});
  }
  const double tank_m = random.uniform(0.3, 0.7) * p.path.length_m();
  for (std::uint64_t u = 0; u < fliers; ++u) {
    const double more = alike ? 1.0 : random.uniform(1.0, 2.0);
    p.fliers.push_back({.tank_m = tank_m * more,
                        .spray_mps = 1.0 / more,
                        .ferry_mps = alike ? 1.0 : random.uniform(0.7, 2.0),
                        .start = alike ? p.depots[0].position : place()});
  }
  return p;
}

/// Inner positions that divide the path into so many equal parts.
inline std::vector<double> cuts_apart_m(const FleetProblem& p, int parts) {
  std::vector<double> cuts_m;
  for (int k = 1; k < parts; ++k) cuts_m.push_back(p.path.length_m() * k / parts);
  return cuts_m;
}

/// All ways to fly these stretches: by whom, in which order, home to where.
class Flown {
 public:
  explicit Flown(const FleetProblem& p) : problem_{p}, clock_{p} {}

  double best_s(const std::vector<double>& ends_m) {
    least_s_ = std::numeric_limits<double>::infinity();
    taken_.assign(ends_m.size() - 1, false);
    plan_.clear();
    add(ends_m);
    return least_s_;
  }

 private:
  void add(const std::vector<double>& ends_m) {
    if (plan_.size() == taken_.size()) {
      least_s_ = std::min(least_s_, clock_.finish(plan_).makespan_s);
      return;
    }
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      if (taken_[i]) continue;
      taken_[i] = true;
      for (std::uint32_t u = 0; u < problem_.fliers.size(); ++u) {
        // Each aircraft's order counts, that of all together does not.
        if (!plan_.empty() && u < plan_.back().flier) continue;
        if (ends_m[i + 1] - ends_m[i] > problem_.fliers[u].tank_m + 1e-9) continue;
        for (std::uint32_t d = 0; d < problem_.depots.size(); ++d) {
          plan_.push_back({ends_m[i], ends_m[i + 1], u, d});
          add(ends_m);
          plan_.pop_back();
        }
      }
      taken_[i] = false;
    }
  }

  const FleetProblem& problem_;
  QueueClock clock_;
  FleetSorties plan_;
  std::vector<char> taken_;
  double least_s_ = 0.0;
};

/// Shortest makespan of all plans that cut at some of `cuts_m`; packs are not looked at.
inline double best_makespan_s(const FleetProblem& p, const std::vector<double>& cuts_m) {
  double least_s = std::numeric_limits<double>::infinity();
  Flown flown{p};
  for (unsigned chosen = 0; chosen < 1U << cuts_m.size(); ++chosen) {
    std::vector<double> ends_m{0.0};
    for (std::size_t k = 0; k < cuts_m.size(); ++k) {
      if ((chosen >> k & 1U) != 0) ends_m.push_back(cuts_m[k]);
    }
    ends_m.push_back(p.path.length_m());
    least_s = std::min(least_s, flown.best_s(ends_m));
  }
  return least_s;
}

}  // namespace furrow::planner::fleet::enumerated
