#include "planner/survey/survey.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace furrow::planner {
namespace {

const Field square{.boundary = {at_m(0, 0), at_m(400, 0), at_m(400, 400), at_m(0, 400)},
                   .holes = {},
                   .obstacles = {}};
const SurveyRule rule{.field = square, .apart = metres(2), .speed = metres_per_second(8)};

FerryMap open(const Field& field, FieldPoint station) {
  const std::vector<FieldPoint> stands{station};
  const auto map = FerryMap::over(field, {}, stands);
  REQUIRE(map);
  return *map;
}

// A hill of 80 m in the middle of the square.
Relief hill(std::vector<KeepOut> keep_out = {}) {
  const AnalyticTerrain ground{.base = {},
                               .peaks = {{.top = at_m(200, 200),
                                          .height = metres(80),
                                          .extent_x = metres(60),
                                          .extent_y = metres(60)}}};
  const HeightRule heights{.spray_height = metres(30), .clearance = metres(15)};
  const Extent extent{at_m(-50, -50), at_m(450, 450)};
  return Relief{TerrainModel{ground, heights, std::move(keep_out)}, extent};
}

double length_m(FieldPoint from, const Strip& visit) {
  double sum_m = 0;
  for (const FieldPoint at : visit.approach) {
    sum_m += distance(from, at).base();
    from = at;
  }
  return sum_m + distance(from, visit.begin).base();
}

Route along_tour(const SurveySettings& survey, const SurveyRule& by, const FerryMap& ferries,
                 FieldPoint from) {
  return survey_route(survey, by, ferries, survey_tour(survey, ferries, from));
}

TEST_CASE("On level land way points are visited by the shortest ways, each once") {
  const FieldPoint station = at_m(0, 0);
  const SurveySettings survey{.way_points = {at_m(300, 300), at_m(100, 100), at_m(200, 200)}};
  const Route route = along_tour(survey, rule, open(square, station), station);
  CHECK(is_survey(route));
  CHECK(route.centers == std::vector{at_m(100, 100), at_m(200, 200), at_m(300, 300)});
  REQUIRE(route.strips.size() == 3);
  for (const Strip& visit : route.strips) {
    CHECK(visit.cells.count == 1);
    CHECK(visit.begin == visit.end);
    CHECK(visit.approach.empty());
    CHECK_FALSE(visit.continues);
  }
  // After a return behind the first visit, the second comes next: nothing is flown twice.
  CHECK(resume_point(route, 0) == at_m(200, 200));
  const auto stops = cell_stops(route, {0, 3});
  CHECK(stops[2].spray_m == 0);
  CHECK(stops[0].skipped_m == Approx(100 * std::sqrt(2)));
}

TEST_CASE("Ways go around holes") {
  Field holed = square;
  holed.holes = {{at_m(150, 150), at_m(250, 150), at_m(250, 250), at_m(150, 250)}};
  const SurveyRule around{.field = holed, .apart = metres(2), .speed = metres_per_second(8)};
  const FieldPoint station = at_m(0, 200);
  const SurveySettings survey{.way_points = {at_m(100, 200), at_m(300, 200)}};
  const FerryMap ferries = open(holed, station);
  for (const bool is_level : {true, false}) {
    const Route route =
        along_tour(survey, around, is_level ? ferries : ferries.over_ground(hill()), station);
    // By two corners: 2 sqrt(50^2 + 50^2) + 100 = 241.4 m.
    CHECK(length_m(at_m(100, 200), route.strips[1]) == Approx(241.4).margin(0.1));
  }
}

TEST_CASE("Over a hill the way is searched in the air and keeps the clearance") {
  const FieldPoint station = at_m(0, 200);
  const Relief relief = hill({{.x_m = 200, .y_m = 290, .radius_m = 30}});
  const FerryMap ferries = open(square, station).over_ground(relief);
  for (const RoutePlanner planner : route_planners) {
    const SurveySettings survey{.way_points = {at_m(60, 200), at_m(340, 210)},
                                .height = metres(30),
                                .search = {.planner = planner, .evaluations = 5000, .seed = 1}};
    const Route route = along_tour(survey, rule, ferries, station);
    const Strip& visit = route.strips[1];
    INFO(name(planner));
    REQUIRE(!visit.approach.empty());
    REQUIRE(visit.approach.size() == visit.approach_altitudes_m.size());
    const auto way =
        relief.way_at(at_m(60, 200), visit.approach, visit.approach_altitudes_m, visit.begin);
    for (std::size_t i = 1; i < way.size(); ++i) {
      for (int k = 0; k <= 50; ++k) {
        const WayPoint p = between(way[i - 1], way[i], k / 50.0);
        CHECK(p.z_m - relief.surface().height_m(p.x_m, p.y_m) > 15);
        CHECK(std::hypot(p.x_m - 200, p.y_m - 290) > 30);
      }
    }
    // Straight it is 280.2 m, with the hill's 80 m to climb over.
    if (planner == RouteSettings{}.planner) CHECK(length_m(at_m(60, 200), visit) < 330);
    // No slower than slopes may make it.
    CHECK(relief.too_steep_m(at_m(60, 200), relief.straight(way, metres_per_second(8))) < 5);
  }
}

}  // namespace
}  // namespace furrow::planner
