#include "planner/fleet/kinds_bound.hpp"

#include "planner/fleet/path_cells.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <vector>

namespace furrow::planner::fleet {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Aircraft that are alike but for where they start.
struct Kind {
  double tank_m, spray_mps, ferry_mps, service_s;
  double count;
};

/// @param of  By flier: its kind; filled in.
std::vector<Kind> kinds_of(const FleetProblem& problem, std::vector<std::size_t>& of) {
  double depot_s = infinite;
  for (const Depot& d : problem.depots) depot_s = std::min(depot_s, d.service_s);
  std::vector<Kind> kinds;
  for (const Flier& f : problem.fliers) {
    const auto known = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) {
      return std::tie(k.tank_m, k.spray_mps, k.ferry_mps) ==
                 std::tie(f.tank_m, f.spray_mps, f.ferry_mps) &&
             k.service_s == depot_s + f.service_s;
    });
    of.push_back(static_cast<std::size_t>(known - kinds.begin()));
    if (known != kinds.end()) {
      known->count += 1.0;
    } else {
      kinds.push_back({f.tank_m, f.spray_mps, f.ferry_mps, depot_s + f.service_s, 1.0});
    }
  }
  return kinds;
}

/// Somewhere to cut the path, or its begin or end: within a cell, or between two strips.
struct Cut {
  double begin_m, end_m;    ///< Of the cell; the same between strips.
  double out_m, home_m;     ///< At their least.
  double landed_m, left_m;  ///< Hops before what is sprayed last, and first, at the cut.
};

class Cuts {
 public:
  Cuts(const FleetProblem& problem, double cell_m)
      : problem_{problem}, places_{places_to_leave(problem)} {
    for (const Depot& d : problem.depots) homes_.push_back(d.position);
    const StripPath& path = problem.path;
    const PathCells cells{path, cell_m};
    all_.reserve(cells.size() + path.strips() + 2);
    const double length_m = path.length_m();
    all_.push_back({0.0, 0.0, out_m(0.0), 0.0, 0.0, 0.0});
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double begin_m = cells.begin_m(i), end_m = cells.end_m(i);
      const std::uint32_t s = cells.strip(i);
      const double hops_m = path.hops_m(0.0, end_m);
      all_.push_back({begin_m, end_m, nearest_m(places_, begin_m, end_m),
                      std::min(problem.most_home_m, nearest_m(homes_, begin_m, end_m)), hops_m,
                      hops_m});
      if (end_m != path.begin_m(s + 1) || s + 1 == path.strips()) continue;
      all_.push_back({end_m, end_m, out_m(end_m), home_m(end_m), hops_m,
                      path.hops_m(0.0, path.begin_m(s + 2))});
    }
    all_.push_back({length_m, length_m, 0.0, home_m(length_m), path.hops_m(0.0, length_m), 0.0});
  }

  const std::vector<Cut>& all() const { return all_; }

 private:
  double out_m(double at_m) const {
    double least_m = infinite;
    for (const FieldPoint p : places_) least_m = std::min(least_m, problem_.path.out_m(p, at_m));
    return least_m;
  }
  double home_m(double at_m) const {
    double least_m = problem_.most_home_m;
    for (const FieldPoint p : homes_) least_m = std::min(least_m, problem_.path.back_m(p, at_m));
    return least_m;
  }
  /// What lies between both ends is no nearer than they are on the mean, less half of the cell.
  double nearest_m(const std::vector<FieldPoint>& places, double begin_m, double end_m) const {
    double least_m = infinite;
    for (const FieldPoint p : places) {
      const double ends_m = problem_.path.out_m(p, begin_m) + problem_.path.back_m(p, end_m);
      least_m = std::min(least_m, 0.5 * (ends_m - (end_m - begin_m)));
    }
    return std::max(least_m, 0.0);
  }

  const FleetProblem& problem_;
  std::vector<FieldPoint> places_, homes_;
  std::vector<Cut> all_;
};

/// A sliding window over cuts that one kind's tank reaches back to, the cheapest first.
class Window {
 public:
  explicit Window(std::size_t cuts) { queue_.reserve(cuts); }

  void add(std::uint32_t cut, double cost) {
    while (queue_.size() > first_ && queue_.back().cost >= cost) queue_.pop_back();
    queue_.push_back({cut, cost});
  }
  double least(const std::vector<Cut>& cuts, double from_m) {
    while (first_ < queue_.size() && cuts[queue_[first_].cut].end_m < from_m) ++first_;
    return first_ < queue_.size() ? queue_[first_].cost : infinite;
  }

 private:
  struct Entry {
    std::uint32_t cut;
    double cost;
  };
  std::vector<Entry> queue_;
  std::size_t first_ = 0;
};

/// The cheapest split by weights, less what the first sorties are spared.
double split_s(const std::vector<Cut>& cuts, const std::vector<Kind>& kinds,
               const std::vector<double>& weights, double fill_s) {
  constexpr double slack_m = 1e-6;
  std::vector<Window> windows(kinds.size(), Window{cuts.size()});
  double least = 0.0, spared = 0.0;
  for (std::size_t k = 0; k < kinds.size(); ++k)
    spared += kinds[k].count * weights[k] * (kinds[k].service_s + fill_s);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const Cut& c = cuts[i];
    if (i > 0) least = infinite;
    for (std::size_t k = 0; i > 0 && k < kinds.size(); ++k) {
      const Kind& kind = kinds[k];
      const double per_m = 1.0 / kind.spray_mps + fill_s / kind.tank_m;
      const double since = windows[k].least(cuts, c.begin_m - kind.tank_m - slack_m);
      const double here = per_m * c.begin_m + (c.landed_m + c.home_m) / kind.ferry_mps;
      least = std::min(least, since + weights[k] * (here + kind.service_s));
    }
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const Kind& kind = kinds[k];
      const double per_m = 1.0 / kind.spray_mps + fill_s / kind.tank_m;
      const double here = (c.out_m - c.left_m) / kind.ferry_mps - per_m * c.end_m;
      windows[k].add(static_cast<std::uint32_t>(i), least + weights[k] * here);
    }
  }
  return least - spared;
}

void normalise(std::vector<double>& weights, const std::vector<Kind>& kinds) {
  double sum = 0.0;
  for (std::size_t k = 0; k < kinds.size(); ++k) sum += kinds[k].count * weights[k];
  for (double& w : weights) w /= sum;
}

std::vector<double> best_weights(const std::vector<Cut>& cuts, const std::vector<Kind>& kinds,
                                 double fill_s) {
  constexpr std::size_t most_kinds = 6;
  std::vector<double> best;
  best.reserve(kinds.size());
  for (const Kind& k : kinds) best.push_back(k.spray_mps);
  normalise(best, kinds);
  if (kinds.size() < 2 || kinds.size() > most_kinds) return best;
  double best_s = split_s(cuts, kinds, best, fill_s);
  for (const double step : std::array{1.25, 1.25, 1.1, 1.1, 1.03}) {
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      for (const double factor : {step, 1.0 / step}) {
        std::vector<double> other = best;
        other[k] *= factor;
        normalise(other, kinds);
        const double other_s = split_s(cuts, kinds, other, fill_s);
        if (other_s <= best_s) continue;
        best_s = other_s;
        best = std::move(other);
      }
    }
  }
  return best;
}

/// When fliers have that much work behind them that is to be done by weights, each within its
/// window; where they never have, when they would without windows.
double done_s(const FleetProblem& problem, const std::vector<std::size_t>& kind_of,
              const std::vector<double>& weights, double work_s) {
  const auto by_s = [&](double at_s) {
    double done_s = 0.0;
    for (std::size_t u = 0; u < kind_of.size(); ++u) {
      const Flier& f = problem.fliers[u];
      done_s += weights[kind_of[u]] * std::max(0.0, std::min(at_s, f.until_s) - f.ready_s);
    }
    return done_s;
  };
  const bool are_free =
      std::all_of(problem.fliers.begin(), problem.fliers.end(),
                  [](const Flier& f) { return f.ready_s == 0.0 && f.until_s == infinite; });
  if (are_free) return work_s;
  double low_s = work_s, high_s = work_s;
  for (int doublings = 0; by_s(high_s) < work_s; ++doublings) {
    if (doublings == 40) return work_s;
    low_s = high_s;
    high_s *= 2.0;
  }
  while (high_s - low_s > 1e-3) {
    const double middle_s = 0.5 * (low_s + high_s);
    (by_s(middle_s) < work_s ? low_s : high_s) = middle_s;
  }
  return low_s;
}

}  // namespace

double kinds_bound_s(const FleetProblem& problem, double cell_m) {
  constexpr double coarser = 8.0;
  std::vector<std::size_t> kind_of;
  const std::vector<Kind> kinds = kinds_of(problem, kind_of);
  double fill_s = infinite;
  for (const Depot& d : problem.depots) fill_s = std::min(fill_s, d.fill_s);
  const Cuts coarse{problem, coarser * cell_m};
  const std::vector<double> weights = best_weights(coarse.all(), kinds, fill_s);
  const double work_s = split_s(Cuts{problem, cell_m}.all(), kinds, weights, fill_s);
  return done_s(problem, kind_of, weights, work_s);
}

}  // namespace furrow::planner::fleet
