#include "planner/routes/plan_route.hpp"

#include "core/require.hpp"
#include "planner/routes/ants.hpp"
#include "planner/routes/evolution.hpp"
#include "planner/routes/lattice.hpp"
#include "planner/routes/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace furrow::planner {
namespace {

constexpr double look_m = 0.5;

Expected<Individual, std::string> not_clear(std::string_view end, WayPoint p, const Scene& scene) {
  return Unexpected{fmt::format(
      "{} ({:.1f}, {:.1f}) at {:.1f} m must be in the box, outside volumes and {:.1f} m above the "
      "terrain at {:.1f} m",
      end, p.x_m, p.y_m, p.z_m, kept_m(scene), scene.surface.height_m(p.x_m, p.y_m))};
}

}  // namespace

std::string_view name(RoutePlanner planner) {
  switch (planner) {
    case RoutePlanner::improved_ga: return "improved_ga";
    case RoutePlanner::plain_ga: return "plain_ga";
    case RoutePlanner::ants: return "ants";
    case RoutePlanner::rrt_star: return "rrt_star";
    case RoutePlanner::bit_star: return "bit_star";
    case RoutePlanner::lattice: return "lattice";
  }
  return "unknown";
}

RouteSearch search_route(const Scene& scene, const RouteSettings& settings) {
  require(settings.evaluations >= 100, "a search has 100 evaluations or more");
  const auto [planner, evaluations, seed] = settings;
  switch (planner) {
    case RoutePlanner::improved_ga: return evolved_route(scene, {}, evaluations, seed);
    case RoutePlanner::plain_ga: return evolved_route(scene, plain_evolution(), evaluations, seed);
    case RoutePlanner::ants: return ant_route(scene, {}, evaluations, seed);
    case RoutePlanner::rrt_star:
      return sampled_route(scene, SamplingPlanner::rrt_star, evaluations, seed);
    case RoutePlanner::bit_star:
      return sampled_route(scene, SamplingPlanner::bit_star, evaluations, seed);
    case RoutePlanner::lattice: break;
  }
  return lattice_route(scene, evaluations, seed);
}

bool is_clear_throughout(const Scene& scene, std::span<const WayPoint> inner, double step_m) {
  RouteJudge judge{scene};
  std::vector<WayPoint> all{scene.start};
  all.insert(all.end(), inner.begin(), inner.end());
  all.push_back(scene.goal);
  const Spline spline{all};
  // No step of the parameter is longer than this share of the longest between two samples.
  double longest_m = 0;
  for (std::size_t i = 1; i < curve_samples; ++i) {
    const auto k = static_cast<double>(i);
    longest_m = std::max(longest_m, distance_m(spline.at((k - 1) / 100), spline.at(k / 100)));
  }
  const double looks = 100 * std::ceil(std::max(1.0, 1.5 * longest_m / step_m));
  for (double i = 0; i <= looks; ++i) {
    if (!judge.is_clear(spline.at(i / looks))) return false;
  }
  return true;
}

Expected<Individual, std::string> plan_route(const Scene& scene, const RouteSettings& settings) {
  if (!is_clear(scene, scene.start)) return not_clear("start", scene.start, scene);
  if (!is_clear(scene, scene.goal)) return not_clear("goal", scene.goal, scene);
  const auto flies = [&](const Individual& one) {
    return one.cost.is_feasible() && is_clear_throughout(scene, one.genes, look_m);
  };
  RouteJudge judge{scene};
  const Individual straight{{}, judge.cost({})};
  if (flies(straight)) return straight;
  // Ground that shows between two samples is passed by keeping further away.
  Scene wider = scene;
  double cost = 0;
  for (const double more_m : {0.0, 2.0, 5.0, 10.0}) {
    wider.clearance_m = scene.clearance_m + more_m;
    RouteSearch search = search_route(wider, settings);
    Individual one{std::move(search.best.genes), {}};
    one.cost = judge.cost(one.genes);
    cost = one.cost.total();
    if (flies(one)) return one;
  }
  return Unexpected{fmt::format(
      "no clear route from ({:.1f}, {:.1f}) to ({:.1f}, {:.1f}) found by {} in {} evaluations; the "
      "best still breaks a rule, at a cost of {:.0f}",
      scene.start.x_m, scene.start.y_m, scene.goal.x_m, scene.goal.y_m, name(settings.planner),
      settings.evaluations, cost)};
}

}  // namespace furrow::planner
