#include "scheduler/plan_fleet.hpp"

#include "core/require.hpp"
#include "scheduler/ceiling.hpp"
#include "scheduler/fleet_returns.hpp"
#include "scheduler/joint_plan.hpp"
#include "scheduler/lower_bound.hpp"
#include "scheduler/near_strips.hpp"
#include "scheduler/path_model.hpp"
#include "scheduler/sketch.hpp"
#include "scheduler/turns_at_near_work.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string>

namespace furrow::scheduler {
namespace {

using planner::PlanError;
using planner::PlanFault;

constexpr int recuts = 3;

/// Who has no share yet, from the station nearest to its home.
UavPlan without_share(const Vehicle& vehicle, const std::vector<Station>& stations) {
  const auto nearest =
      std::min_element(stations.begin(), stations.end(), [&](const Station& a, const Station& b) {
        return distance(vehicle.home, a.position) < distance(vehicle.home, b.position);
      });
  return {.vehicle = vehicle,
          .station = *nearest,
          .strips = {0, 0},
          .cells = {0, 0},
          .solution = {},
          .visits = {},
          .spray_ends_s = 0,
          .lands_s = 0,
          .joins_late = true};
}

std::optional<PlanError> fleet_fault(const std::vector<Vehicle>& vehicles) {
  const Vehicle& first = vehicles.front();
  for (const Vehicle& v : vehicles) {
    const std::string who = "UAV " + std::to_string(number(v.id));
    if (v.swath != first.swath) {
      return PlanError{PlanFault::swaths_differ, who + " sprays " + std::to_string(v.swath.base()) +
                                                     " m, UAV " + std::to_string(number(first.id)) +
                                                     " " + std::to_string(first.swath.base()) +
                                                     " m"};
    }
    if (tank_range(v) < v.swath) {
      return PlanError{PlanFault::tank_too_small,
                       who + ": a tank lasts for " + std::to_string(tank_range(v).base()) +
                           " m, a cell takes " + std::to_string(v.swath.base()) + " m"};
    }
  }
  return std::nullopt;
}

std::vector<FleetTask> tasks(const FleetProblem& problem, const Sketch& s,
                             const std::vector<Share>& shares) {
  std::vector<FleetTask> all;
  for (std::size_t u = 0; u < problem.vehicles.size(); ++u) {
    const Vehicle& vehicle = problem.vehicles[u];
    const Share& share = shares[u];
    FleetTask task{.agent = vehicle.id, .station = share.station, .problem = {}, .times = {}};
    if (share.strips.count > 0) {
      const CellRange cells = cells_of(s.coverage.route, share.strips);
      task.problem =
          planner::return_problem(s.coverage.route, cells, vehicle, problem.stations[share.station],
                                  part(s.lengths.stations[share.station], cells));
      task.times.emplace(s.coverage.route, *task.problem);
    }
    all.push_back(std::move(task));
  }
  return all;
}

/// Shares with their return points.
struct Solved {
  std::vector<Share> shares;
  std::vector<FleetTask> tasks;
  FleetReturns returns;
};

Expected<Solved, PlanError> solved(const FleetProblem& problem, const Sketch& s,
                                   std::vector<Share> shares, double budget_s) {
  std::vector<FleetTask> all = tasks(problem, s, shares);
  planner::SolveSettings settings = problem.solver;
  settings.budget_s = budget_s;
  // Of many aircraft the joint search finds far better than shares: it needs but a start.
  constexpr std::size_t many = 50;
  if (settings.returns == planner::ReturnStrategy::joint && problem.vehicles.size() > many) {
    settings.returns = planner::ReturnStrategy::simple;
  }
  auto returns = fleet_returns(all, problem.stations, settings);
  if (!returns) return Unexpected{returns.error()};
  return Solved{std::move(shares), std::move(all), std::move(*returns)};
}

bool same_strips(const std::vector<Share>& a, const std::vector<Share>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Share& x, const Share& y) { return x.strips == y.strips; });
}

/// The drafted shares solved, and cut again a few times by how long they take.
Expected<Solved, PlanError> best_solved(const FleetProblem& problem, const Sketch& s) {
  if (problem.vehicles.size() == 1) {
    return solved(problem, s, s.draft.shares, problem.solver.budget_s);
  }
  const double budget_s = problem.solver.budget_s / (1 + recuts);
  auto best = solved(problem, s, s.draft.shares, budget_s);
  if (!best) return best;
  Solved latest = *best;
  for (int round = 0; round < recuts; ++round) {
    auto shares = recut(s.coverage.route, s.lengths, problem.vehicles, problem.stations,
                        latest.shares, latest.returns.forecast.spray_ends_s);
    if (same_strips(shares, latest.shares)) break;
    auto other = solved(problem, s, std::move(shares), budget_s);
    if (!other) break;
    latest = std::move(*other);
    if (worth(latest.returns.forecast) < worth(best->returns.forecast)) best = latest;
  }
  return best;
}

/// Those who come late count from then on. On surveys, whose strips have no length, of contiguous
/// shares only. An aircraft alone with one station has its solver's bound besides.
MakespanBound lower_bound(const FleetProblem& problem, const Sketch& s,
                          const Expected<Solved, PlanError>& found) {
  const std::vector<Vehicle> fleet = whole_fleet(problem);
  const planner::Route& route = s.coverage.route;
  MakespanBound bound = fleet_bound(route, fleet, problem.stations);
  if (bound.name.empty()) {
    bound = {makespan_bound_s(route, s.lengths, fleet, problem.stations), "shares"};
  }
  if (fleet.size() > 1 || problem.stations.size() > 1 || !found) return bound;
  const planner::ReturnProblem& only = *found->tasks[0].problem;
  const double by_returns_s = only.fly_out_m / only.vehicle.ferry_speed.base() +
                              only.on_route_s.back() + found->returns.solutions[0].lower_bound_s;
  return by_returns_s > bound.makespan_s ? MakespanBound{by_returns_s, "returns"} : bound;
}

/// The plan as lists.
SortieLists lists_of(const Sketch& s, const Solved& found) {
  SortieLists lists(found.shares.size());
  for (std::size_t u = 0; u < lists.size(); ++u) {
    lists[u] = sorties_of(cells_of(s.coverage.route, found.shares[u].strips),
                          found.returns.solutions[u].plan.returns, found.shares[u].station);
  }
  return lists;
}

/// Sorties chosen for the fleet together, where there is a choice and the settings want it.
std::optional<JointPlan> jointly(const FleetProblem& problem, const Sketch& s,
                                 const Expected<Solved, PlanError>& found) {
  const auto closes = [](const Station& at) { return at.available_until.has_value(); };
  const bool has_choice = problem.vehicles.size() > 1 || problem.stations.size() > 1 ||
                          closes(problem.stations[0]) ||
                          (found && !found->returns.forecast.is_sure);
  if (!has_choice || !planner::is_by_gravity(problem.solver.returns) || problem.survey) {
    return std::nullopt;
  }
  const Length near = problem.separation
                          ? near_work(*problem.separation, problem.vehicles.front().swath)
                          : Length{};
  auto joint =
      joint_plan(s.coverage.route, s.lengths, problem.vehicles, problem.stations, problem.solver,
                 found ? lists_of(s, *found) : SortieLists(problem.vehicles.size()), {}, near);
  if (joint && near > Length{}) {
    joint->flown = turned_at_near_work(std::move(joint->flown), s.coverage.route, s.lengths,
                                       problem.vehicles, problem.stations, near);
  }
  return joint;
}

/// The first service of the shares that its station closes before.
std::optional<PlanError> late_service(const FleetProblem& problem, const Solved& found) {
  for (std::size_t u = 0; u < problem.vehicles.size(); ++u) {
    const Station& at = problem.stations[found.shares[u].station];
    const auto until = planned_until(at);
    for (const Visit& visit : found.returns.forecast.visits[u]) {
      if (!until || visit.ready_s <= until->base()) continue;
      return PlanError{
          PlanFault::hours_too_short,
          fmt::format("station {} would serve UAV {} until {:.1f} s, it closes at "
                      "{:.1f} s, of which plans keep the last {:.1f} s",
                      number(at.id), number(problem.vehicles[u].id), visit.ready_s,
                      at.available_until->base(), (*at.available_until - *until).base()),
          at.position};
    }
  }
  return std::nullopt;
}

/// Why nothing is planned: what hinders the shares, or which hours or whose window are too short
/// for them.
PlanError refusal(const FleetProblem& problem, const Expected<Solved, PlanError>& found) {
  if (!found) return found.error();
  if (auto late = late_service(problem, *found)) return std::move(*late);
  const Forecast& shares = found->returns.forecast;
  std::size_t u = 0;
  while (u + 1 < problem.vehicles.size() && is_in_time(problem.vehicles[u], shares.lands_s[u])) ++u;
  const Vehicle& late = problem.vehicles[u];
  return {PlanFault::window_too_short,
          fmt::format("UAV {} lands at {:.1f} s, its window ends at {:.1f} s, of which plans keep "
                      "the last {:.1f} s",
                      number(late.id), shares.lands_s[u], late.available_until->base(),
                      (*late.available_until - *planned_until(late)).base())};
}

std::vector<UavPlan> planned_shares(const FleetProblem& problem, const Sketch& s, Solved& found) {
  std::vector<UavPlan> plans;
  for (std::size_t u = 0; u < problem.vehicles.size(); ++u) {
    const Share& share = found.shares[u];
    plans.push_back({.vehicle = problem.vehicles[u],
                     .station = problem.stations[share.station],
                     .strips = share.strips,
                     .cells = cells_of(s.coverage.route, share.strips),
                     .solution = std::move(found.returns.solutions[u]),
                     .visits = std::move(found.returns.forecast.visits[u]),
                     .spray_ends_s = found.returns.forecast.spray_ends_s[u],
                     .lands_s = found.returns.forecast.lands_s[u]});
  }
  return plans;
}

// Bounds count corners as sharp, and walks of a grid cut them with the valve open. A plan below a
// bound refutes it.
void forget_refuted_bound(FleetPlan& plan) {
  if (plan.lower_bound_s <= (1 + 1e-9) * plan.makespan_s) return;
  plan.lower_bound_s = 0.0;
  plan.bound.clear();
}

Yardsticks yardsticks(const JointPlan& joint, bool is_joint) {
  return {.shares_s = {},
          .till_empty_s = joint.till_empty_s,
          .simple_s = joint.simple_s,
          .evaluations = joint.evaluations,
          .is_joint = is_joint};
}

void add_joining(FleetPlan& plan, const FleetProblem& problem) {
  for (const Vehicle& vehicle : problem.joining) {
    plan.uavs.push_back(without_share(vehicle, problem.stations));
  }
  std::sort(plan.uavs.begin(), plan.uavs.end(),
            [](const UavPlan& a, const UavPlan& b) { return a.vehicle.id < b.vehicle.id; });
}

}  // namespace

Expected<FleetPlan, PlanError> plan_fleet(const FleetProblem& problem) {
  require(!problem.vehicles.empty() && !problem.stations.empty(),
          "a fleet has aircraft and stations");
  if (auto fault = fleet_fault(whole_fleet(problem))) return Unexpected{std::move(*fault)};
  auto sketched = best_sketch(problem);
  if (!sketched) return Unexpected{sketched.error()};
  Sketch& s = *sketched;
  auto found = best_solved(problem, s);
  auto joint = jointly(problem, s, found);
  const bool may_share = found && is_in_time(problem.vehicles, found->returns.forecast);
  if (!joint && !may_share) return Unexpected{refusal(problem, found)};
  const bool is_joint = joint && (!may_share || !found->returns.forecast.is_sure ||
                                  worth(joint->flown.forecast) < worth(found->returns.forecast));
  MakespanBound bound = lower_bound(problem, s, found);
  FleetPlan plan{.route = {},
                 .sweep = s.coverage.sweep,
                 .safety = safety_of(problem),
                 .work_direction_deg = s.coverage.direction_deg,
                 .uavs = {},
                 .makespan_s = is_joint ? joint->flown.forecast.makespan_s
                                        : found->returns.forecast.makespan_s,
                 .lower_bound_s = bound.makespan_s,
                 .bound = std::move(bound.name)};
  if (joint) {
    plan.yardsticks = yardsticks(*joint, is_joint);
    if (may_share) plan.yardsticks->shares_s = found->returns.forecast.makespan_s;
  }
  if (is_joint) {
    plan.uavs = std::move(joint->flown.uavs);
    plan.route = std::move(joint->flown.order.route);
  } else {
    plan.uavs = planned_shares(problem, s, *found);
    plan.route = std::move(s.coverage.route);
  }
  forget_refuted_bound(plan);
  if (auto fault = ceiling_fault(plan, problem.stations)) return Unexpected{std::move(*fault)};
  add_joining(plan, problem);
  return plan;
}

}  // namespace furrow::scheduler
