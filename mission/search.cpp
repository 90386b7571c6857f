#include "mission/search.hpp"

#include <algorithm>

namespace furrow::mission {

std::optional<planner::RouteSettings> read_search(const Section& s,
                                                  const planner::RouteSettings& otherwise,
                                                  std::uint32_t most,
                                                  const std::optional<std::string>& none) {
  const auto& planners = planner::route_planners;
  std::vector<std::string> names;
  for (const planner::RoutePlanner p : planners) names.emplace_back(planner::name(p));
  if (none) names.push_back(*none);
  planner::RouteSettings search = otherwise;
  const auto usual = std::find(std::begin(planners), std::end(planners), search.planner);
  const auto chosen =
      s.choice("planner", names, static_cast<std::size_t>(usual - std::begin(planners)));
  search.evaluations = s.whole("evaluations", 100, most, search.evaluations);
  if (chosen == std::size(planners)) return std::nullopt;
  search.planner = planners[chosen];
  return search;
}

}  // namespace furrow::mission
