#include "planner/fleet/solve.hpp"

#include "planner/fleet/by_station.hpp"
#include "planner/fleet/cut_plan.hpp"
#include "planner/fleet/till_empty.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace furrow::planner::fleet {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Judged {
  FleetSorties sorties;
  Finish finish;
};

/// What the makespan may grow by at first, as a share. Where the budget is too small for a plan of
/// so many sorties to settle again, it is not unsettled; for cool searches plans of more than a few
/// are far slower to settle than their number says.
double heat(std::size_t sorties, const FleetSolveSettings& settings, std::uint64_t budget) {
  constexpr double most = 0.01, changes_each = 200.0, few = 16.0;
  const double n = static_cast<double>(sorties);
  const double slower = settings.is_cool ? std::pow(std::max(1.0, n / few), 4.0) : 1.0;
  return most * std::min(1.0, static_cast<double>(budget) / (changes_each * n * n * slower));
}

/// Anneals from one plan after another, and remembers the best of all.
class Annealer {
 public:
  Annealer(const FleetProblem& problem, const FleetSolveSettings& settings)
      : problem_{problem}, settings_{settings}, clock_{problem}, random_{settings.seed} {}

  Judged judged(FleetSorties sorties) {
    ++evaluations_;
    const Finish finish = clock_.finish(sorties);
    return {std::move(sorties), finish};
  }
  std::uint64_t evaluations() const { return evaluations_; }

  /// @param budget  Sorties flown, or changes refused.
  Judged annealed(const Judged& start, std::uint64_t budget) {
    Judged best = start;
    CutPlan now{problem_, start.sorties};
    double now_s = energy_s(start.finish);
    clock_.finish(now.sorties());
    clock_.keep();
    const double cold_s = 1e-4 * start.finish.makespan_s;
    const double hot_s =
        std::max(cold_s, heat(start.sorties.size(), settings_, budget) * start.finish.makespan_s);
    for (std::uint64_t spent = 0; spent < budget; ++spent) {
      CutPlan next = now;
      if (!next.change(random_)) continue;
      const Finish finish = clock_.finish(next.sorties());
      if (!finish.is_carried) continue;
      ++evaluations_;
      spent += next.sorties().size();
      const double part = static_cast<double>(spent) / static_cast<double>(budget);
      const double heat_s = hot_s * std::pow(cold_s / hot_s, part);
      const double next_s = energy_s(finish);
      if (next_s > now_s && random_.uniform() >= std::exp((now_s - next_s) / heat_s)) continue;
      clock_.keep();
      now = std::move(next);
      now_s = next_s;
      if (is_better(finish, best.finish)) best = {now.sorties(), finish};
    }
    return best;
  }

 private:
  /// The makespan, with a slope where one aircraft alone decides it, and what landing late costs.
  double energy_s(const Finish& f) const {
    constexpr double each_late = 3.0;
    return f.makespan_s + 0.05 * f.total_s / static_cast<double>(problem_.fliers.size()) +
           each_late * f.late_s;
  }

  const FleetProblem& problem_;
  const FleetSolveSettings& settings_;
  QueueClock clock_;
  Random random_;
  std::uint64_t evaluations_ = 0;
};

/// Equal stretches, so many in all.
std::optional<FleetSorties> equal_stretches(const FleetProblem& problem, double count) {
  const double each_m = problem.path.length_m() / count;
  return dealt_out(problem, [&](double from_m) {
    return problem.path.length_m() * ((std::floor(from_m / each_m + 1e-6) + 1.0) / count);
  });
}

std::vector<FleetSorties> equal_starts(const FleetProblem& problem) {
  double tank_m = 0.0;
  for (const Flier& f : problem.fliers) tank_m = std::max(tank_m, f.tank_m);
  const double least = std::ceil(problem.path.length_m() / tank_m);
  const auto fliers = static_cast<double>(problem.fliers.size());
  std::vector<FleetSorties> starts;
  for (const double rounds : {1.0, 2.0, 3.0}) {
    const double count = std::ceil(least / fliers) * fliers * rounds;
    if (auto start = equal_stretches(problem, count)) starts.push_back(std::move(*start));
  }
  return starts;
}

/// Each station's aircraft on their own stretch of the path, apart.
/// @param settings  Without starts, which are of the whole path.
std::optional<FleetSorties> solved_by_station(const FleetProblem& problem,
                                              const FleetSolveSettings& settings,
                                              std::uint64_t& evaluations) {
  const std::vector<StationPart> parts = by_station(problem);
  if (parts.empty()) return std::nullopt;
  FleetSolveSettings each = settings;
  each.budget /= parts.size();
  std::vector<FleetSorties> sorties;
  sorties.reserve(parts.size());
  for (const StationPart& part : parts) {
    auto solution = solved(part.problem, each);
    if (!solution) return std::nullopt;
    evaluations += solution->evaluations;
    sorties.push_back(std::move(solution->sorties));
  }
  return of_whole(problem, parts, sorties);
}

}  // namespace

std::optional<FleetSolution> solved(const FleetProblem& problem,
                                    const FleetSolveSettings& settings) {
  Annealer annealer{problem, settings};
  std::vector<Judged> starts;
  FleetSolution solution{{}, {}, infinite, infinite, 0};
  const auto add = [&](std::optional<FleetSorties> sorties) {
    if (!sorties) return infinite;
    starts.push_back(annealer.judged(std::move(*sorties)));
    return starts.back().finish.makespan_s;
  };
  solution.till_empty_s = add(till_empty(problem));
  solution.simple_s = add(simple_sorties(problem));
  for (FleetSorties& s : equal_starts(problem)) add(std::move(s));
  for (const FleetSorties& s : settings.starts) {
    if (is_carried(problem, s)) add(s);
  }
  std::uint64_t budget = settings.budget;
  if (problem.depots.size() > 1) {
    budget /= 2;
    FleetSolveSettings apart = settings;
    apart.budget = budget;
    apart.starts.clear();
    add(solved_by_station(problem, apart, solution.evaluations));
  }
  if (starts.empty()) return std::nullopt;

  std::stable_sort(starts.begin(), starts.end(),
                   [](const Judged& a, const Judged& b) { return is_better(a.finish, b.finish); });
  Judged best = starts.front();
  const std::size_t runs = std::min<std::size_t>(starts.size(), settings.runs);
  for (std::size_t r = 0; r < runs; ++r) {
    Judged found = annealer.annealed(starts[r], budget / runs);
    if (is_better(found.finish, best.finish)) best = std::move(found);
  }
  solution.sorties = std::move(best.sorties);
  solution.finish = best.finish;
  solution.evaluations += annealer.evaluations();
  return solution;
}

}  // namespace furrow::planner::fleet
