#include "scheduler/fleet_problem.hpp"

#include <algorithm>

namespace furrow::scheduler {

std::vector<Vehicle> whole_fleet(const FleetProblem& problem) {
  std::vector<Vehicle> all = problem.vehicles;
  all.insert(all.end(), problem.joining.begin(), problem.joining.end());
  std::sort(all.begin(), all.end(), [](const Vehicle& a, const Vehicle& b) { return a.id < b.id; });
  return all;
}

Length safety_of(const FleetProblem& problem) {
  return problem.survey && problem.terrain ? Length{} : planner::safety_of(problem.coverage);
}

Length corner_cut(const FleetProblem& problem) { return 0.5 * problem.vehicles.front().swath; }

}  // namespace furrow::scheduler
