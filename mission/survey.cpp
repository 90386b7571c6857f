#include "mission/survey.hpp"

#include "mission/polygon.hpp"
#include "mission/search.hpp"

#include <algorithm>

namespace furrow::mission {
namespace {

constexpr std::uint32_t most_evaluations = 10'000'000;  // for each of them
constexpr std::size_t most_way_points = 500;

std::vector<FieldPoint> read_way_points(const Section& survey, const Field& field) {
  std::vector<FieldPoint> places;
  for (const auto& s : survey.list("way_points", 0, most_way_points)) {
    const FieldPoint at = s.point("at_m");
    if (!s.has("at_m")) continue;
    const bool is_off = !contains(field.boundary, at) ||
                        std::any_of(field.holes.begin(), field.holes.end(),
                                    [&](const Ring& hole) { return contains(hole, at); });
    if (!field.boundary.empty() && is_off) {
      s.fail("at_m", "must lie inside the boundary and outside the holes", text(at));
    } else if (std::find(places.begin(), places.end(), at) != places.end()) {
      s.fail("at_m", "must differ from the other way points", text(at));
    }
    places.push_back(at);
  }
  return places;
}

}  // namespace

std::optional<planner::SurveySettings> read_survey(const Section& root, Scenario& scenario) {
  const Section s = root.section("survey");
  planner::SurveySettings survey{.way_points = read_way_points(s, scenario.field),
                                 .height = metres(s.number("height_m", above_to(0, 1000), 30)),
                                 .search = *read_search(s, {}, most_evaluations)};
  if (!root.has("survey")) return std::nullopt;
  if (survey.way_points.empty()) {
    s.fail("way_points", "must hold at least one way point");
    return std::nullopt;
  }
  const Section terrain = root.section("terrain");
  if (terrain.has("spray_height_m")) {
    terrain.fail("spray_height_m", "must be left out beside survey, whose height_m is flown");
  }
  if (scenario.terrain) scenario.terrain->rule.spray_height = survey.height;
  return survey;
}

}  // namespace furrow::mission
