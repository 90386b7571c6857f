#include "planner/fleet/priced_split.hpp"

#include "planner/fleet/path_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow::planner::fleet {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Fastest {
  double spray_mps = 0.0, ferry_mps = 0.0, tank_m = 0.0;
};

Fastest fastest(const FleetProblem& problem) {
  Fastest best;
  for (const Flier& f : problem.fliers) {
    best.spray_mps = std::max(best.spray_mps, f.spray_mps);
    best.ferry_mps = std::max(best.ferry_mps, f.ferry_mps);
    best.tank_m = std::max(best.tank_m, f.tank_m);
  }
  best.tank_m += 1e-6;
  return best;
}

/// Of the nearest of `places`, metres.
double out_m(const StripPath& path, const std::vector<FieldPoint>& places, double at_m) {
  double least_m = infinite;
  for (const FieldPoint p : places) least_m = std::min(least_m, path.out_m(p, at_m));
  return least_m;
}
/// Of the nearest depot, metres.
/// @param after  Of spraying on just after `at_m` instead of up to it.
double back_m(const FleetProblem& problem, double at_m, bool after) {
  double least_m = problem.most_home_m;
  for (const Depot& d : problem.depots)
    least_m = std::min(least_m, after ? problem.path.out_m(d.position, at_m)
                                      : problem.path.back_m(d.position, at_m));
  return least_m;
}

}  // namespace

PricedSplit::PricedSplit(const FleetProblem& problem, double level_s, double cell_m)
    : level_s_{level_s} {
  tabulate(problem, cell_m);
  const std::size_t ends = lands_s_.size();
  double longest_s = 0.0;
  for (std::size_t i = 1; i < ends; ++i)
    longest_s = std::max(longest_s, lands_s_[i] - leaves_s_[tank_from_[i]]);
  levels_ = static_cast<std::size_t>(std::max(1.0, std::ceil(longest_s / level_s - 1e-9)));
  from_.resize(ends * levels_);
  for (std::size_t j = 0; j < levels_; ++j) {
    const double most_s =
        j + 1 == levels_ ? infinite : static_cast<double>(j + 1) * level_s_ + 1e-9;
    std::uint32_t k = 0;
    for (std::uint32_t i = 1; i < ends; ++i) {
      k = std::max(k, tank_from_[i]);
      while (k < i && lands_s_[i] - leaves_s_[k] > most_s) ++k;
      from_[i * levels_ + j] = k;
    }
  }
  least_.resize(ends);
  by_.resize(ends);
  measure_sprayed();
}

void PricedSplit::measure_sprayed() {
  double most_m = 0.0;
  for (std::size_t j = 0; j < levels_; ++j) {
    for (std::uint32_t i = 1; i < lands_s_.size(); ++i) {
      const std::uint32_t k = from_[i * levels_ + j];
      if (k < i) most_m = std::max(most_m, ends_m_[i] - begins_m_[k]);
    }
    sprayed_.push_back(std::min(most_m / tank_m_, 1.0));
  }
}

void PricedSplit::tabulate(const FleetProblem& problem, double cell_m) {
  const PathCells cells{problem.path, cell_m};
  const Fastest best = fastest(problem);
  const StripPath& path = problem.path;
  const std::vector<FieldPoint> places = places_to_leave(problem);
  const double length_m = path.length_m();
  const std::size_t n = cells.size();
  tank_m_ = best.tank_m;
  begins_m_.resize(n + 1);
  ends_m_.resize(n + 2);
  leaves_s_.resize(n + 1);
  lands_s_.resize(n + 2);
  tank_from_.resize(n + 2, 0);
  for (std::size_t i = 0; i <= n; ++i) {
    const double at_m = i == 0 ? 0.0 : cells.end_m(i - 1);
    begins_m_[i] = i == 0 ? 0.0 : cells.begin_m(i - 1);
    const double hops_m = i == n ? path.hops_m(0.0, length_m)
                                 : path.hops_m(0.0, length_m) - path.hops_m(at_m, length_m);
    leaves_s_[i] = at_m / best.spray_mps + (hops_m - out_m(path, places, at_m)) / best.ferry_mps;
    if (i > 0) leaves_s_[i] = std::max(leaves_s_[i], leaves_s_[i - 1]);
  }
  std::uint32_t k = 0;
  for (std::size_t i = 1; i <= n + 1; ++i) {
    const bool end = i == n + 1;
    const double at_m = end ? length_m : cells.begin_m(i - 1);
    ends_m_[i] = end ? length_m : cells.end_m(i - 1);
    const double hops_m = path.hops_m(0.0, length_m) - (end ? 0.0 : path.hops_m(at_m, length_m));
    lands_s_[i] = at_m / best.spray_mps + (hops_m + back_m(problem, at_m, !end)) / best.ferry_mps;
    while (k > 0 ? cells.end_m(k - 1) < at_m - best.tank_m : at_m > best.tank_m) ++k;
    tank_from_[i] = k;
  }
  for (std::size_t i = n + 1; i-- > 1;) lands_s_[i] = std::min(lands_s_[i], lands_s_[i + 1]);
}

double PricedSplit::least(std::span<const double> prices, std::span<double> counts) {
  const std::size_t ends = lands_s_.size();
  least_[0] = 0.0;
  for (std::size_t i = 1; i < ends; ++i) {
    double least = infinite;
    std::uint32_t by = 0;
    for (std::uint32_t j = 0; j < levels_; ++j) {
      const std::uint32_t k = from_[i * levels_ + j];
      if (k == i) continue;
      const double cost = least_[k] + prices[j];
      if (cost < least) {
        least = cost;
        by = j;
      }
    }
    least_[i] = least;
    by_[i] = by;
  }
  std::fill(counts.begin(), counts.end(), 0.0);
  for (std::size_t i = ends - 1; i > 0; i = from_[i * levels_ + by_[i]]) counts[by_[i]] += 1.0;
  return least_[ends - 1];
}

}  // namespace furrow::planner::fleet
