#include "planner/fleet/bound.hpp"

#include "planner/fleet/kinds_bound.hpp"
#include "planner/fleet/work_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow::planner::fleet {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double fastest_mps(const Flier& f) { return std::max(f.spray_mps, f.ferry_mps); }

/// Shortest time from an aircraft's start to a strip's begin or end and home from there.
double round_s(const FleetProblem& problem, std::uint32_t strip, bool end) {
  const auto away_m = [&](FieldPoint place) {
    return end ? problem.path.back_m(place, problem.path.begin_m(strip + 1))
               : problem.path.out_m(place, problem.path.begin_m(strip));
  };
  double back_m = problem.most_home_m, least_s = infinite;
  for (const Depot& d : problem.depots) back_m = std::min(back_m, away_m(d.position));
  for (const Flier& f : problem.fliers)
    least_s = std::min(least_s, (away_m(f.start) + back_m) / fastest_mps(f));
  return least_s;
}

/// Nowhere on the path is nearer to a place; of all its strips.
double nearest_m(const StripPath& path, FieldPoint place) {
  double least_m = infinite;
  for (std::uint32_t s = 0; s < path.strips(); ++s) {
    const double length_m = path.begin_m(s + 1) - path.begin_m(s);
    const double ends_m =
        path.out_m(place, path.begin_m(s)) + path.back_m(place, path.begin_m(s + 1));
    least_m = std::min(least_m, 0.5 * (ends_m - length_m));
  }
  return std::max(least_m, 0.0);
}

bool is_weaker(const LowerBound& a, const LowerBound& b) { return a.makespan_s < b.makespan_s; }

/// No way home to the best depot is longer.
double longest_home_m(const FleetProblem& problem) {
  double most_m = 0.0;
  for (std::uint32_t s = 0; s < problem.path.strips(); ++s) {
    double best_m = infinite;
    for (const Depot& d : problem.depots) {
      const double begin_m = problem.path.out_m(d.position, problem.path.begin_m(s));
      const double end_m = problem.path.back_m(d.position, problem.path.begin_m(s + 1));
      best_m = std::min(best_m, std::max(begin_m, end_m));
    }
    most_m = std::max(most_m, best_m);
  }
  return most_m;
}

}  // namespace

LowerBound farthest_point_bound(const FleetProblem& problem) {
  double most_s = 0.0;
  for (std::uint32_t s = 0; s < problem.path.strips(); ++s)
    most_s = std::max({most_s, round_s(problem, s, false), round_s(problem, s, true)});
  return {most_s, "farthest point"};
}

LowerBound bay_count_bound(const FleetProblem& problem) {
  double tank_m = 0.0, fastest = 0.0, service_s = infinite;
  double depot_s = infinite, depot_m = infinite, start_m = infinite, bays = 0.0;
  for (const Depot& d : problem.depots) {
    depot_s = std::min(depot_s, d.service_s);
    depot_m = std::min(depot_m, nearest_m(problem.path, d.position));
    bays += d.bays;
  }
  for (const Flier& f : problem.fliers) {
    tank_m = std::max(tank_m, f.tank_m);
    fastest = std::max(fastest, fastest_mps(f));
    service_s = std::min(service_s, depot_s + f.service_s);
    start_m = std::min(start_m, nearest_m(problem.path, f.start));
  }
  const double sorties = std::ceil(problem.path.length_m() / tank_m - 1e-9);
  const double fills = sorties - static_cast<double>(problem.fliers.size());
  if (fills <= 0.0) return {0.0, "bay count"};
  const double ways_m = start_m + depot_m + 2.0 * std::min(problem.most_home_m, depot_m);
  return {std::ceil(fills / bays) * service_s + ways_m / fastest, "bay count"};
}

namespace {

LowerBound landing_bound(const FleetProblem& problem, double cell_m, const BayBoundSettings& bays) {
  const LowerBound best = std::max({LowerBound{work_bound_s(problem, cell_m), "work"},
                                    LowerBound{kinds_bound_s(problem, cell_m), "work"},
                                    bay_count_bound(problem), farthest_point_bound(problem)},
                                   is_weaker);
  const double by_bays_s = bay_bound_s(problem, best.makespan_s, bays);
  return by_bays_s > best.makespan_s ? LowerBound{by_bays_s, "bays"} : best;
}

/// What all bays together need to serve and fill, shared among them.
LowerBound filling_bound(const FleetProblem& problem) {
  double filled_m = problem.path.length_m(), tank_m = 0.0, bays = 0.0;
  double service_s = infinite, fill_s = infinite;
  for (const Flier& f : problem.fliers) {
    filled_m -= f.tank_m;
    tank_m = std::max(tank_m, f.tank_m);
    for (const Depot& d : problem.depots)
      service_s = std::min(service_s, d.service_s + f.service_s);
  }
  for (const Depot& d : problem.depots) {
    fill_s = std::min(fill_s, d.fill_s);
    bays += d.bays;
  }
  if (filled_m <= 0.0) return {0.0, "filling"};
  const double tanks = filled_m / tank_m;
  return {(std::ceil(tanks - 1e-9) * service_s + tanks * fill_s) / bays, "filling"};
}

LowerBound spraying_bound(const FleetProblem& problem, double cell_m,
                          const BayBoundSettings& bays) {
  constexpr double coarser = 8.0, first_m = 4.0;
  double slowest_mps = infinite;
  for (const Flier& f : problem.fliers) slowest_mps = std::min(slowest_mps, f.ferry_mps);
  FleetProblem relaxed = problem;
  double best_s = 0.0, best_home_m = 0.0;
  const double longest_m = longest_home_m(problem);
  for (double home_m = 0.0; home_m < 2.0 * longest_m + first_m;
       home_m = std::max(first_m, 2.0 * home_m)) {
    relaxed.most_home_m = std::min(home_m, longest_m);
    const double work_s =
        kinds_bound_s(relaxed, coarser * cell_m) - relaxed.most_home_m / slowest_mps;
    if (work_s <= best_s) continue;
    best_s = work_s;
    best_home_m = relaxed.most_home_m;
  }
  relaxed.most_home_m = best_home_m;
  LowerBound best = landing_bound(relaxed, cell_m, bays);
  best.makespan_s = std::max(0.0, best.makespan_s - best_home_m / slowest_mps);
  return best;
}

}  // namespace

LowerBound best_bound(const FleetProblem& problem, const BayBoundSettings& bays) {
  constexpr double finest_m = 0.25, most_cells = 200'000, busy = 0.8;
  const double cell_m = std::max(finest_m, problem.path.length_m() / most_cells);
  const auto flown = [&](const BayBoundSettings& settings) {
    return problem.ends_sprayed ? spraying_bound(problem, cell_m, settings)
                                : landing_bound(problem, cell_m, settings);
  };
  const BayBoundSettings thorough;
  const LowerBound filling = filling_bound(problem);
  LowerBound best = std::max(flown(bays), filling, is_weaker);
  const bool is_busy = filling.makespan_s > busy * best.makespan_s;
  if (is_busy && bays.fine_slots < thorough.fine_slots) {
    best = std::max(best, flown(thorough), is_weaker);
  }
  return best;
}

}  // namespace furrow::planner::fleet
