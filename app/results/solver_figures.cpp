#include "app/results/solver_figures.hpp"

#include "planner/returns/continuous_bracket.hpp"
#include "planner/returns/unplanned.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace furrow::app {
namespace {

// Steps for the bracket of one aircraft: a judgement, not the plan, so it may stay unproven.
constexpr std::uint64_t bracket_work = 200'000'000;

// Flying until empty, and breaking anywhere: none where some aircraft's cannot be told.
void add_yardsticks(const MissionRecord& record, SolverFigures& f) {
  double until_empty_s = 0, anywhere_s = 0, widest = 0;
  bool is_told = true;
  const bool is_level = record.plan.route.ferries.relief() == nullptr;
  const bool is_joint = record.plan.yardsticks && record.plan.yardsticks->is_joint;
  const std::vector<planner::Strip>& strips = record.plan.route.strips;
  const bool is_to_ends = std::all_of(strips.begin(), strips.end(), planner::sprays_ends);
  bool is_bracketed = record.plan.sweep.has_value() && is_to_ends && is_level && !is_joint;
  std::map<StationId, planner::StationLengths> lengths;
  for (const scheduler::UavPlan& uav : record.plan.uavs) {
    if (uav.cells.count == 0) continue;
    const auto [known, is_new] = lengths.try_emplace(uav.station.id);
    if (is_new) {
      known->second = planner::station_lengths(record.plan.route, uav.station.position);
    }
    const auto problem = planner::return_problem(record.plan.route, uav.cells, uav.vehicle,
                                                 uav.station, part(known->second, uav.cells));
    const auto until_empty = planner::unplanned_plan(problem);
    is_told = is_told && until_empty;
    if (until_empty) until_empty_s += until_empty->non_spray_s;
    if (!is_bracketed) continue;
    const auto bracket =
        planner::continuous_bracket(record.plan.route, problem, {.work_budget = bracket_work});
    is_bracketed = bracket.has_value();
    if (!bracket) continue;
    anywhere_s += bracket->lower_s;
    widest = std::max(widest, bracket->gap());
  }
  if (is_told) f.until_empty_s = until_empty_s;
  if (is_bracketed) {
    f.anywhere_lower_bound_s = anywhere_s;
    f.anywhere_gap = widest;
  }
}

}  // namespace

std::optional<double> gap_above(double value, double bound) {
  if (bound > 0) return value / bound - 1;
  return value == 0 ? std::optional{0.0} : std::nullopt;
}

// A plan with waits in its objective may still reach the bound without them.
bool is_proven(const planner::Solution& solution) {
  const double bound_s = solution.lower_bound_s;
  return solution.proven ||
         (bound_s > 0 && std::abs(solution.plan.non_spray_s - bound_s) <= 1e-9 * bound_s);
}

SolverFigures solver_figures(const MissionRecord& record) {
  const planner::SolveSettings& settings = record.scenario.solver;
  const bool is_joint = record.plan.yardsticks && record.plan.yardsticks->is_joint;
  const bool is_gsa = planner::is_by_gravity(settings.returns) && !is_joint;
  SolverFigures f{};
  f.returns = planner::name(settings.returns);
  f.refined = is_gsa && settings.refine;
  f.proven = !is_joint;
  f.wall_s = record.timing.solver_wall_s;
  double gsa_s = 0;
  for (const scheduler::UavPlan& uav : record.plan.uavs) {
    const planner::Solution& solution = uav.solution;
    f.return_points += static_cast<std::uint32_t>(solution.plan.returns.size());
    f.round_trips_m += solution.plan.round_trips_m;
    f.swaps += solution.plan.swaps;
    for (const planner::PlannedSortie& s : solution.plan.sorties) {
      f.swap_s += s.battery_swap_s;
      f.fill_s += s.fill_s;
      f.service_s += s.service_s;
    }
    f.non_spray_s += solution.plan.non_spray_s;
    f.lower_bound_s += solution.lower_bound_s;
    f.proven = f.proven && (is_proven(solution) || uav.cells.count == 0);
    f.evaluations += solution.evaluations;
    gsa_s += solution.gsa_objective_s;
  }
  f.yardsticks = record.plan.yardsticks;
  if (f.yardsticks) f.evaluations += f.yardsticks->evaluations;
  if (is_gsa) f.gsa_s = gsa_s;
  add_yardsticks(record, f);
  if (f.proven) f.optimum_s = f.lower_bound_s;
  f.gap = gap_above(f.non_spray_s, f.lower_bound_s);
  return f;
}

}  // namespace furrow::app
