#include "planner/routes/sampling.hpp"

#include "planner/routes/smoothing.hpp"

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <cstdint>
#include <memory>

namespace furrow::planner {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

using Space = ob::RealVectorStateSpace;

constexpr double share_for_search = 0.95;
constexpr double looks_along_the_way = 100;  // as many as a curve has samples

WayPoint place(const ob::State* state) {
  const double* v = state->as<Space::StateType>()->values;
  return {v[0], v[1], v[2]};
}

ob::ScopedState<Space> state(const ob::StateSpacePtr& space, WayPoint p) {
  ob::ScopedState<Space> s{space};
  s[0] = p.x_m;
  s[1] = p.y_m;
  s[2] = p.z_m;
  return s;
}

std::shared_ptr<Space> space_of(const Scene& scene) {
  auto space = std::make_shared<Space>(3);
  ob::RealVectorBounds bounds{3};
  bounds.low = {scene.low.x_m, scene.low.y_m, scene.low.z_m};
  bounds.high = {scene.high.x_m, scene.high.y_m, scene.high.z_m};
  space->setBounds(bounds);
  space->setLongestValidSegmentFraction(distance_m(scene.start, scene.goal) / looks_along_the_way /
                                        space->getMaximumExtent());
  return space;
}

ob::PlannerPtr planner_of(SamplingPlanner planner, const ob::SpaceInformationPtr& space) {
  if (planner == SamplingPlanner::bit_star) return std::make_shared<og::BITstar>(space);
  auto tree = std::make_shared<og::RRTstar>(space);
  tree->setInformedSampling(true);
  return tree;
}

// Corners of the best polyline; empty where none was found.
std::vector<WayPoint> polyline(SamplingPlanner planner, RouteJudge& judge, double evaluations,
                               std::uint64_t seed) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(1 + mixed(seed) % 0x7fffffff));
  const Scene& scene = judge.scene();
  const ob::StateSpacePtr space = space_of(scene);
  og::SimpleSetup setup{space};
  setup.setStateValidityChecker([&](const ob::State* s) { return judge.is_clear(place(s)); });
  setup.setStartAndGoalStates(state(space, scene.start), state(space, scene.goal));
  setup.setOptimizationObjective(
      std::make_shared<ob::PathLengthOptimizationObjective>(setup.getSpaceInformation()));
  setup.setPlanner(planner_of(planner, setup.getSpaceInformation()));
  std::uint64_t turns = 0;  // some turns look nothing up: they are bounded too
  const auto most_turns = static_cast<std::uint64_t>(4 * evaluations);
  const ob::PlannerTerminationCondition is_over{
      [&] { return judge.evaluations() >= evaluations || ++turns > most_turns; }};
  try {
    setup.solve(is_over);
  } catch (const ompl::Exception&) {
    return {};
  }
  if (!setup.haveExactSolutionPath()) return {};
  std::vector<WayPoint> line;
  for (const ob::State* s : setup.getSolutionPath().getStates()) line.push_back(place(s));
  return line;
}

}  // namespace

RouteSearch sampled_route(const Scene& scene, SamplingPlanner planner, std::uint64_t evaluations,
                          std::uint64_t seed) {
  RouteJudge judge{scene};
  const double budget = share_for_search * static_cast<double>(evaluations);
  std::vector<WayPoint> line = polyline(planner, judge, budget, seed);
  if (line.empty()) {
    line = {scene.start, scene.goal};
  } else {
    line = pulled(line, judge, distance_m(scene.start, scene.goal) / looks_along_the_way);
  }
  Individual best = fitted(line, judge);
  const double total = best.cost.total();
  return {std::move(best), {total}, judge.evaluations()};
}

}  // namespace furrow::planner
