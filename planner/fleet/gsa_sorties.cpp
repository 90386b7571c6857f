#include "planner/fleet/gsa_sorties.hpp"

#include "planner/fleet/queue_clock.hpp"
#include "planner/fleet/till_empty.hpp"
#include "planner/search/gsa.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace furrow::planner::fleet {
namespace {

constexpr double no_plan_s = 1e12;

/// The path dealt out by shares of the longest tank; where they run out, till empty.
class Shares {
 public:
  explicit Shares(const FleetProblem& problem) : problem_{problem} {
    for (const Flier& f : problem.fliers) tank_m_ = std::max(tank_m_, f.tank_m);
  }

  std::optional<FleetSorties> sorties(std::span<const double> shares) const {
    std::size_t n = 0;
    return dealt_out(problem_, [&](double from_m) {
      return from_m + (n < shares.size() ? shares[n++] : 1.0) * tank_m_;
    });
  }
  std::vector<double> shares(const FleetSorties& sorties, std::size_t count) const {
    std::vector<double> result(count, 1.0);
    for (std::size_t i = 0; i < std::min(count, sorties.size()); ++i)
      result[i] = (sorties[i].to_m - sorties[i].from_m) / tank_m_;
    return result;
  }

 private:
  const FleetProblem& problem_;
  double tank_m_ = 0.0;
};

}  // namespace

std::optional<FleetSorties> gsa_sorties(const FleetProblem& problem,
                                        const GsaSortiesSettings& settings) {
  constexpr double least_share = 0.05;
  auto best = till_empty(problem);
  if (!best) return std::nullopt;
  const Shares code{problem};
  QueueClock clock{problem};
  const auto simple = simple_sorties(problem);
  const std::size_t count =
      std::max(best->size(), simple ? simple->size() : 0) + problem.fliers.size();
  GsaProblem gravity{.low = std::vector<double>(count, least_share),
                     .high = std::vector<double>(count, 1.0),
                     .objective = {}};
  const auto cost_s = [&](const std::optional<FleetSorties>& sorties) {
    if (!sorties) return no_plan_s;
    const Finish finish = clock.finish(*sorties);
    return finish.makespan_s + finish.late_s;
  };
  gravity.objective = [&](std::span<const double> shares) { return cost_s(code.sorties(shares)); };
  gravity.starts.emplace_back(count, 1.0);
  double best_s = cost_s(best);
  const auto keep = [&](std::optional<FleetSorties> other) {
    const double other_s = cost_s(other);
    if (other_s >= best_s) return;
    best_s = other_s;
    best = std::move(other);
  };
  if (simple) {
    gravity.starts.push_back(code.shares(*simple, count));
    keep(simple);
  }
  const GsaResult found = gsa_minimum(
      gravity,
      {.masses = settings.masses, .iterations = settings.iterations, .seed = settings.seed});
  keep(code.sorties(found.best));
  return best;
}

}  // namespace furrow::planner::fleet
