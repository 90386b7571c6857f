#include "planner/fleet/work_bound.hpp"

#include "planner/fleet/path_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow::planner::fleet {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The fleet's best aircraft, in the measure that the bound counts work in.
struct Measure {
  double speeds_mps = 0.0, ratio = infinite, service_m = infinite, tank_m = 0.0;
};

Measure measure(const FleetProblem& problem) {
  Measure best;
  double depot_s = infinite;
  for (const Depot& d : problem.depots) depot_s = std::min(depot_s, d.service_s);
  for (const Flier& f : problem.fliers) {
    best.speeds_mps += f.spray_mps;
    best.ratio = std::min(best.ratio, f.spray_mps / f.ferry_mps);
    best.service_m = std::min(best.service_m, f.spray_mps * (depot_s + f.service_s));
    best.tank_m = std::max(best.tank_m, f.tank_m);
  }
  return best;
}

/// Of the ways there are, metres.
class Ways {
 public:
  explicit Ways(const FleetProblem& problem)
      : path_{problem.path}, most_home_m_{problem.most_home_m}, starts_{places_to_leave(problem)} {
    for (const Depot& d : problem.depots) homes_.push_back(d.position);
  }

  double out_m(double at_m) const {
    double least_m = infinite;
    for (const FieldPoint p : starts_) least_m = std::min(least_m, path_.out_m(p, at_m));
    return least_m;
  }
  double back_m(double at_m) const {
    double least_m = most_home_m_;
    for (const FieldPoint p : homes_) least_m = std::min(least_m, path_.back_m(p, at_m));
    return least_m;
  }
  /// To a cell's nearest position and away from it again, at least.
  double round_m(const PathCells& cells, std::size_t i) const {
    return std::min(most_home_m_, nearest_m(homes_, cells, i)) + nearest_m(starts_, cells, i);
  }

 private:
  /// Both ends of the cell are as far, or nearer than, what lies between them, less half of it.
  double nearest_m(const std::vector<FieldPoint>& places, const PathCells& cells,
                   std::size_t i) const {
    const double begin_m = cells.begin_m(i), end_m = cells.end_m(i);
    double least_m = infinite;
    for (const FieldPoint p : places) {
      const double begin_away_m = path_.out_m(p, begin_m), end_away_m = path_.back_m(p, end_m);
      least_m = std::min(least_m, 0.5 * (begin_away_m + end_away_m - (end_m - begin_m)));
    }
    return std::max(least_m, 0.0);
  }

  const StripPath& path_;
  double most_home_m_;
  std::vector<FieldPoint> homes_, starts_;
};

/// What a cut in each cell costs, in metres flown.
std::vector<double> cut_costs_m(const FleetProblem& problem, const PathCells& cells,
                                const Ways& ways) {
  std::vector<double> costs_m(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    costs_m[i] = ways.round_m(cells, i);
    const double end_m = cells.end_m(i);
    const std::uint32_t s = cells.strip(i);
    if (end_m != problem.path.begin_m(s + 1) || s + 1 == problem.path.strips()) continue;
    const double hop_m = problem.path.hops_m(cells.begin_m(i), problem.path.begin_m(s + 2));
    costs_m[i] = std::min(costs_m[i], ways.back_m(end_m) + ways.out_m(end_m) - hop_m);
  }
  return costs_m;
}

/// Cheapest cuts one after the other: `before[k]` costs what is sprayed up to some place in cell k.
class Cuts {
 public:
  Cuts(const PathCells& cells, const std::vector<double>& costs_m, double tank_m)
      : cells_{cells}, costs_m_{costs_m}, tank_m_{tank_m + 1e-6}, queue_(cells.size()) {}

  /// The cheapest of any number.
  double any_m() {
    std::vector<double> costs(cells_.size(), infinite);
    return extend(costs, costs, true);
  }

  /// Fills `after` with the costs of one cut more, or of any number if both are the same vector.
  /// @return  The cost of the whole path, one sortie more.
  double extend(const std::vector<double>& before, std::vector<double>& after, bool from_begin) {
    first_ = last_ = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      while (first_ < last_ && cells_.end_m(queue_[first_]) <= cells_.begin_m(i) - tank_m_)
        ++first_;
      double least = first_ < last_ ? before[queue_[first_]] : infinite;
      if (from_begin && cells_.begin_m(i) < tank_m_) least = std::min(least, 0.0);
      after[i] = least + costs_m_[i];
      while (first_ < last_ && before[queue_[last_ - 1]] >= before[i]) --last_;
      queue_[last_++] = i;
    }
    const double end_m = cells_.end_m(cells_.size() - 1);
    double least = from_begin && end_m <= tank_m_ ? 0.0 : infinite;
    for (std::size_t i = cells_.size(); i-- > 0 && cells_.end_m(i) >= end_m - tank_m_;)
      least = std::min(least, before[i]);
    return least;
  }

 private:
  const PathCells& cells_;
  const std::vector<double>& costs_m_;
  double tank_m_;
  std::vector<std::size_t> queue_;  ///< Cells within the tank whose costs rise.
  std::size_t first_ = 0, last_ = 0;
};

/// Every cut takes a service: as many sorties as aircraft there are in any case.
double cheapest_serviced_m(const PathCells& cells, std::vector<double> costs_m, const Measure& m) {
  for (double& c : costs_m) c += m.service_m;
  return Cuts{cells, costs_m, m.tank_m}.any_m();
}

/// Cuts and the services after the first sorties.
double cheapest_m(const PathCells& cells, const std::vector<double>& costs_m, const Measure& m,
                  double fliers) {
  Cuts cuts{cells, costs_m, m.tank_m};
  const double any_m = cuts.any_m();
  std::vector<double> before(cells.size(), infinite), after(cells.size());
  const auto services_m = [&](double sorties) {
    return std::max(0.0, sorties - fliers) * m.service_m;
  };
  double best_m = infinite;
  for (double sorties = 1.0; any_m + services_m(sorties) < best_m; ++sorties) {
    best_m = std::min(best_m, cuts.extend(before, after, sorties == 1.0) + services_m(sorties));
    std::swap(before, after);
  }
  return best_m;
}

}  // namespace

double work_bound_s(const FleetProblem& problem, double cell_m) {
  const PathCells cells{problem.path, cell_m};
  const Measure m = measure(problem);
  const Ways ways{problem};
  const double length_m = problem.path.length_m();
  const double ferry_m =
      ways.out_m(0.0) + problem.path.hops_m(0.0, length_m) + ways.back_m(length_m);
  const auto fliers = static_cast<double>(problem.fliers.size());
  std::vector<double> costs_m = cut_costs_m(problem, cells, ways);
  for (double& c : costs_m) c *= m.ratio;
  const double least_m = length_m / m.tank_m > fliers - 1.0
                             ? cheapest_serviced_m(cells, costs_m, m) - (fliers - 1.0) * m.service_m
                             : cheapest_m(cells, costs_m, m, fliers);
  return (length_m + m.ratio * ferry_m + least_m) / m.speeds_mps;
}

}  // namespace furrow::planner::fleet
