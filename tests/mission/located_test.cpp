#include "mission/located.hpp"
#include "mission/fleet.hpp"
#include "mission/load.hpp"
#include "scheduler/plan_fleet.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <string>

namespace furrow::mission {
namespace {

// What planning says of a scenario whose lines of those numbers, from 1, are others.
std::string no_plan(const std::map<std::size_t, std::string>& others) {
  std::vector<std::string> lines{
      "version: 1",
      "name: a",
      "field:",
      "  datum: {lat_deg: 0, lon_deg: 30}",
      "  boundary_m: [[0,0],[100,0],[100,50],[0,50]]",
      "  holes_m: [[[10,10],[20,10],[20,20],[10,20]]]",
      "  coverage:",
      "    margin_m: 0",
      "supply:",
      "  - {id: 4, position_m: [0,-5], battery_swap_s: 60, fill: {base_s: 20, full_s: 60}}",
      "uavs:",
      "  - ferry_speed_mps: 6",
      "    spray_speed_mps: 3",
      "    swath_m: 2",
      "    flight_endurance_s: 1500",
      "    spray_endurance_s: 900"};
  for (const auto& [number, line] : others) lines[number - 1] = line;
  std::string yaml;
  for (const std::string& one : lines) yaml += one + "\n";
  const auto read = parse(yaml, "a.yaml");
  if (!read) FAIL(text(read.error().front()));
  const auto plan = scheduler::plan_fleet(fleet_problem(*read));
  REQUIRE(!plan);
  return text(located(plan.error(), *read));
}

TEST_CASE("located: a margin that takes the whole field is a fault of its line", "[mission]") {
  // Half of 50 m and more; the land is 5000 m2 less the hole of 100 m2.
  CHECK(no_plan({{8, "    margin_m: 30"}}) ==
        "a.yaml:8: field.coverage.margin_m: must leave land to fly over (got a margin of 30 m "
        "leaves nothing of a field of 4900.0 m2)");
}

TEST_CASE("located: a station in a hole is a fault of its line, with the place", "[mission]") {
  // On the equator 15 m are 15 / 111319.49 degrees of longitude, 15 / 110574.28 of latitude.
  CHECK(no_plan({{10,
                  "  - {id: 4, position_m: [15,15], battery_swap_s: 60, fill: {base_s: 20, full_s: "
                  "60}}"}}) ==
        "a.yaml:10: supply[0].position_m: must reach the field: each place from some station, "
        "there and back on one pack "
        "(got (15.000, 15.000) m lies in a hole or an obstacle, or too near to one; (15, 15) m, "
        "lat 0.0001357, lon 30.0001347)");
}

TEST_CASE("located: a pack too small for the field is a fault of the station it flies from",
          "[mission]") {
  const std::string message = no_plan({{15, "    flight_endurance_s: 12"}});
  CHECK_THAT(message, Catch::StartsWith("a.yaml:10: supply[0].position_m: must reach the field"));
}

TEST_CASE("located: too many rows are a fault of the swath", "[mission]") {
  // Rows of 0.1 m across 30 km.
  CHECK_THAT(no_plan({{5, "  boundary_m: [[0,0],[30000,0],[30000,30000],[0,30000]]"},
                      {14, "    swath_m: 0.1"}}),
             Catch::StartsWith("a.yaml:14: uavs[0].swath_m: must cut the field into fewer rows"));
}

TEST_CASE("located: rows that are all too short are a fault of the fleet's swath", "[mission]") {
  CHECK(no_plan({{8, "    min_strip_m: 1000"}}) ==
        "a.yaml:14: uavs[0].swath_m: must leave something to spray (got no strip of 2 m swath and "
        "at least 1000 m fits)");
}

TEST_CASE("located: a keep-out volume over a station is a fault of the volume's line",
          "[mission]") {
  CHECK_THAT(
      no_plan({{1,
                "version: 1\nterrain:\n  base: {a: 1, b: 1, c: 1}\n  keep_out:\n"
                "    - {center_m: [-90,0], radius_m: 5}\n"
                "    - {center_m: [0,-9], radius_m: 5}"}}),
      Catch::StartsWith("a.yaml:6: terrain.keep_out[1].center_m: must leave the field, "
                        "stations, starts and way points free (got the keep-out volume at (0.000, "
                        "-9.000) m reaches over (0.000, -5.000) m"));
}

TEST_CASE("located: a keep-out volume over a way point of a survey is a fault of its line",
          "[mission]") {
  CHECK_THAT(no_plan({{1,
                       "version: 1\nterrain:\n  base: {a: 1, b: 1, c: 1}\n  keep_out:\n"
                       "    - {center_m: [60,30], radius_m: 5}\n"
                       "survey:\n  height_m: 30\n  way_points: [{at_m: [58,30]}]"}}),
             Catch::StartsWith("a.yaml:5: terrain.keep_out[0].center_m: must leave the field, "
                               "stations, starts and way points free (got the keep-out volume at "
                               "(60.000, 30.000) m reaches over the way point (58.000, 30.000) m"));
}

TEST_CASE("located: a ceiling too low for ferries is a fault of its line", "[mission]") {
  CHECK_THAT(no_plan({{1,
                       "version: 1\nterrain:\n  peaks: [{top_m: [50,25], height_m: 40, "
                       "extent_east_m: 50, extent_north_m: 50}]\n  ceiling_m: 45\n"
                       "  ferries: {planner: shortest}"}}),
             Catch::StartsWith("a.yaml:4: terrain.ceiling_m: must let ferries over the ground on "
                               "their way (got ferries need 5"));
}

}  // namespace
}  // namespace furrow::mission
