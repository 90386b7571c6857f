#include "mission/load.hpp"
#include "mission/polygon.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

namespace furrow::mission {
namespace {

using Catch::Contains;

const std::string rest =
    "supply:\n  - {id: 4, position_m: [0,-5], battery_swap_s: 60, fill: {base_s: 20, full_s: "
    "60}}\n"
    "uavs:\n  - {swath_m: 2, spray_speed_mps: 3, ferry_speed_mps: 6, flight_endurance_s: 1500, "
    "spray_endurance_s: 900}\n";

// A field of 100 m x 50 m with those holes.
Scenario with_holes(const std::string& holes, const std::string& more = {}) {
  const auto read =
      parse("version: 1\nname: a\nfield:\n" + more +
                "  boundary_m: [[0,0],[100,0],[100,50],[0,50]]\n  holes_m: " + holes + "\n" + rest,
            "test.yaml");
  if (!read) FAIL(text(read.error().front()));
  return *read;
}

double holes_m2(const Scenario& s) {
  double sum = 0;
  for (const Ring& hole : s.field.holes) sum += area(hole).base();
  return sum;
}

TEST_CASE("outline: holes that touch or overlap are one, holes apart stay as they are",
          "[mission]") {
  const Scenario apart = with_holes("[[[10,10],[20,10],[20,20]], [[30,10],[40,10],[40,20]]]");
  CHECK(apart.field.holes[1] == Ring{at_m(30, 10), at_m(40, 10), at_m(40, 20)});
  CHECK(apart.warnings.empty());

  // Two of 20 m x 10 m that share half: 30 m x 10 m.
  const Scenario overlap =
      with_holes("[[[10,10],[30,10],[30,20],[10,20]], [[20,10],[40,10],[40,20],[20,20]]]");
  CHECK(overlap.field.holes.size() == 1);
  CHECK(holes_m2(overlap) == Approx(300));

  // Two of 10 m x 10 m with a side in common.
  const Scenario touch =
      with_holes("[[[10,10],[20,10],[20,20],[10,20]], [[20,10],[30,10],[30,20],[20,20]]]");
  CHECK(touch.field.holes.size() == 1);
  CHECK(holes_m2(touch) == Approx(200));

  const Scenario nested =
      with_holes("[[[10,10],[40,10],[40,40],[10,40]], [[20,20],[30,20],[30,30]]]");
  CHECK(nested.field.holes.size() == 1);
  CHECK(holes_m2(nested) == Approx(900));
  CHECK(nested.warnings.empty());
}

TEST_CASE("outline: holes that touch or cross the boundary are cut at it", "[mission]") {
  const Scenario touch = with_holes("[[[0,10],[20,10],[20,20],[0,20]]]");
  CHECK(holes_m2(touch) == Approx(200));
  // Half of 20 m x 10 m lies within.
  const Scenario cross = with_holes("[[[90,10],[110,10],[110,20],[90,20]]]");
  CHECK(holes_m2(cross) == Approx(100));
  CHECK(cross.field.boundary.size() == 4);
  // A ditch of 2 m from edge to edge.
  const Scenario ditch = with_holes("[[[50,-5],[52,-5],[52,55],[50,55]]]");
  CHECK(holes_m2(ditch) == Approx(100));
  for (const Scenario& s : {touch, cross, ditch}) CHECK(s.warnings.empty());
}

TEST_CASE("outline: a hole outside is left out with a warning that says where", "[mission]") {
  const Scenario s = with_holes("[[[10,10],[20,10],[20,20]], [[200,10],[210,10],[210,20]]]",
                                "  datum: {lat_deg: 0, lon_deg: 30}\n");
  CHECK(s.field.holes.size() == 1);
  // On the equator 200 m are 200 / 111319.49 degrees of longitude, 10 m are 10 / 110574.28 of
  // latitude.
  CHECK(s.warnings ==
        std::vector<std::string>{
            "test.yaml:6: field.holes_m[1]: warning: hole 2 lies outside the boundary and is left "
            "out, at (200, 10) m, lat 0.0000904, lon 30.0017966"});
}

TEST_CASE("outline: land that holes close in is left out with a warning", "[mission]") {
  // Four bars around 20 m x 10 m: with it 30 m x 20 m.
  const Scenario s = with_holes(
      "[[[10,10],[40,10],[40,15],[10,15]], [[10,25],[40,25],[40,30],[10,30]], "
      "[[10,10],[15,10],[15,30],[10,30]], [[35,10],[40,10],[40,30],[35,30]]]");
  CHECK(holes_m2(s) == Approx(600));
  REQUIRE(s.warnings.size() == 1);
  CHECK_THAT(s.warnings[0],
             Contains("field.boundary_m: warning: the land has land that holes close in"));
}

// A field from a GeoJSON file of those corners, near the equator.
Expected<Scenario, std::vector<ScenarioError>> from_file(const std::string& corners,
                                                         const std::string& properties = "{}") {
  const auto folder = std::filesystem::temp_directory_path() / "furrow_outline_test";
  std::filesystem::create_directories(folder);
  std::ofstream{folder / "farm.geojson"} << R"({"type": "Feature", "properties": )" << properties
                                         << R"(, "geometry": {"type": "Polygon", "coordinates": [[)"
                                         << corners << "]]}}";
  std::ofstream{folder / "a.yaml"} << "version: 1\nname: a\nfield:\n  file: farm.geojson\n" << rest;
  auto read = load((folder / "a.yaml").string());
  std::filesystem::remove_all(folder);
  return read;
}

TEST_CASE("outline: mended land of a file is said with the place of the fault", "[mission]") {
  // A spike without width, out of the east side to longitude 30.003 at latitude 0.0005.
  const auto read = from_file(
      "[30, 0], [30.002, 0], [30.002, 0.0005], [30.003, 0.0005], [30.002, 0.0005], "
      "[30.002, 0.001], [30, 0.001], [30, 0]");
  REQUIRE(read);
  REQUIRE(read->warnings.size() == 1);
  CHECK_THAT(read->warnings[0], Contains("a.yaml:4: field.file: warning: the land crosses or "
                                         "touches itself and is mended, at ("));
  CHECK_THAT(read->warnings[0], Contains("lat 0.0005000, lon 30.00"));
  CHECK_THAT(read->warnings[0], Contains(" in farm.geojson"));
}

TEST_CASE("outline: an area stated otherwise than the land is warned of with both", "[mission]") {
  const std::string corners = "[30, 0], [30.002, 0], [30.002, 0.001], [30, 0.001], [30, 0]";
  // 0.002 x 0.001 degrees at the equator: 222.6390 m x 110.5743 m = 24618.1 m2.
  const auto near = from_file(corners, R"({"area_ha": 2.463})");  // 0.05 % more
  REQUIRE(near);
  CHECK(near->stated_area == hectares(2.463));
  CHECK(near->warnings.empty());
  const auto off = from_file(corners, R"({"area_ha": 2.5})");
  REQUIRE(off);
  REQUIRE(off->warnings.size() == 1);
  CHECK_THAT(off->warnings[0],
             Contains("a.yaml:4: field.file: warning: farm.geojson states 25000.0 m2 (2.5000 ha), "
                      "its land within the boundary and outside the holes has 24618.1 m2 (2.4618 "
                      "ha), -1.53 %"));
}

TEST_CASE("outline: land of a file that crosses itself is refused with the place", "[mission]") {
  const auto read = from_file("[30, 0], [30.002, 0.001], [30.002, 0], [30, 0.002], [30, 0]");
  REQUIRE(!read);
  REQUIRE(read.error().size() == 1);
  CHECK(read.error()[0].key == "field.file");
  CHECK(read.error()[0].rule == "must be rings that do not cross themselves");
  // The sides y = x / 2 and y = 0.002 - x cross at x = 0.001333, y = 0.000667.
  CHECK_THAT(read.error()[0].value, Contains("lat 0.0006667, lon 30.0013333 in farm.geojson"));
}

}  // namespace
}  // namespace furrow::mission
