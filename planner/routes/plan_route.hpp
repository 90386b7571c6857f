#pragma once
// One door to all ways of finding a route.

#include "core/expected.hpp"
#include "planner/routes/route_search.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace furrow::planner {

enum class RoutePlanner { improved_ga, plain_ga, ants, rrt_star, bit_star, lattice };

/// As scenarios and tables name it.
std::string_view name(RoutePlanner planner);

/// All of them, in the order of the enumeration.
inline constexpr RoutePlanner route_planners[] = {RoutePlanner::improved_ga, RoutePlanner::plain_ga,
                                                  RoutePlanner::ants,        RoutePlanner::rrt_star,
                                                  RoutePlanner::bit_star,    RoutePlanner::lattice};

struct RouteSettings {
  RoutePlanner planner = RoutePlanner::lattice;
  std::uint64_t evaluations = 20'000;  ///< >= 100
  std::uint64_t seed = 0;
};

/// The search alone, whatever it ends with.
RouteSearch search_route(const Scene& scene, const RouteSettings& settings);

/// A route that keeps terrain and clearance, box, keep-out volumes and limits, looked at every half
/// metre, or why there is none: start or goal are not clear, or the budget ended
/// before a feasible curve was found. The straight line is taken where it is one.
Expected<Individual, std::string> plan_route(const Scene& scene, const RouteSettings& settings);

/// Whether the curve by `inner` is clear at steps of at most `step_m`, between its samples too.
bool is_clear_throughout(const Scene& scene, std::span<const WayPoint> inner, double step_m);

}  // namespace furrow::planner
