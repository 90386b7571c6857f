#include "app/conduct.hpp"
#include "mission/fleet.hpp"
#include "scheduler/plan_fleet.hpp"

#include <cstdio>
#include <optional>
#include <string>

namespace furrow::app {
namespace {

// A simple plan shows that there is one; that there is none, only the scenario's own search does.
std::optional<planner::PlanError> plan_fault(const mission::Scenario& scenario) {
  const scheduler::FleetProblem problem = mission::fleet_problem(scenario);
  scheduler::FleetProblem simple = problem;
  simple.solver.returns = planner::ReturnStrategy::simple;
  simple.solver.budget_s = 0;
  if (scheduler::plan_fleet(simple)) return std::nullopt;
  const auto plan = scheduler::plan_fleet(problem);
  return plan ? std::nullopt : std::optional{plan.error()};
}

std::string counted(std::size_t n, const char* noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

}  // namespace

int check(const Options& options) {
  const auto scenario = load(options);
  if (!scenario) return scenario.error();
  if (const auto fault = plan_fault(*scenario)) {
    tell(*fault, *scenario);
    return Exit::bad_input;
  }
  std::printf("%s: sound: %s, %s\n", options.scenario.c_str(),
              counted(scenario->uavs.size(), "UAV").c_str(),
              counted(scenario->stations.size(), "station").c_str());
  return Exit::done;
}

}  // namespace furrow::app
