#include "exchange/land.hpp"

#include "tests/exchange/ground.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <limits>

namespace {

using namespace furrow;
using namespace furrow::exchange;
using ground::area_m2;
using ground::quad_m2;

const std::string folder = "tests/exchange/land/";

Land land(const std::string& file, std::size_t feature) {
  const auto read = read_land(folder + file, feature);
  INFO((read ? "" : text(read.error())));
  REQUIRE(read);
  return *read;
}

std::string refusal(const std::string& file, std::optional<std::size_t> feature = 0) {
  const auto read = read_land(folder + file, feature);
  REQUIRE(!read);
  const std::string message = text(read.error());
  REQUIRE(message.find('\n') == std::string::npos);
  return message.substr(folder.size());
}

std::string refusal_of(std::string bytes) {
  const auto read = read_land(LandFile{.path = "a", .bytes = std::move(bytes)});
  REQUIRE(!read);
  return text(read.error());
}

TEST_CASE("A KML file gives its polygons in order, with holes, without heights") {
  const Land pond = land("two_fields.kml", 0);
  REQUIRE(pond.features == 3);  // the field, and both parts of the twins; the gate is a point
  REQUIRE(pond.name == "pond field");
  REQUIRE(pond.field.boundary.size() == 4);
  REQUIRE(pond.field.holes.size() == 1);
  // 0.002 x 0.004 degrees less a pond of 0.0005 x 0.001 degrees
  const double expected_m2 = quad_m2(51.781, 0.002, 0.004) - quad_m2(51.78075, 0.0005, 0.001);
  REQUIRE(area_m2(pond.field) == Approx(expected_m2).epsilon(1e-6));
  REQUIRE(land("two_fields.kml", 2).name == "twins");
  REQUIRE(land("two_fields.kml", 2).datum.lon_deg == Approx(4.28133).epsilon(1e-5));
}

TEST_CASE("A polygon that the file does not have is refused with the number that it has") {
  REQUIRE(
      refusal("two_fields.kml", 3) ==
      "two_fields.kml: feature must be 0 to 2, as the file has 3 polygons: 0 pond field, 1 twins, "
      "2 twins (got 3)");
  REQUIRE(refusal("across_equator_and_null_meridian.wkt", 1) ==
          "across_equator_and_null_meridian.wkt: feature must be 0 to 0, as the file has one "
          "polygon: 0 nameless (got 1)");
}

TEST_CASE("A file of several polygons is read only when one of them is chosen") {
  CHECK(refusal("two_fields.kml", std::nullopt) ==
        "two_fields.kml: feature must choose one of 3 polygons: 0 pond field, 1 twins, 2 twins "
        "(got no feature)");
  CHECK(read_land(folder + "across_equator_and_null_meridian.wkt"));  // it has one only
}

TEST_CASE("A field across the equator and the null meridian is one piece") {
  const Land read = land("across_equator_and_null_meridian.wkt", 0);
  REQUIRE(read.datum == Datum{.lat_deg = 0, .lon_deg = 0});
  REQUIRE(area_m2(read.field) == Approx(quad_m2(0, 0.002, 0.002)).epsilon(1e-6));
  // 0.001 degrees west and south of the centre: 111.3195 m and 110.5743 m on WGS84
  REQUIRE(read.field.boundary.front().x.base() == Approx(-111.3195).epsilon(1e-6));
  REQUIRE(read.field.boundary.front().y.base() == Approx(-110.5743).epsilon(1e-6));
}

TEST_CASE("A field across the antimeridian is one piece, also when the file cuts it there") {
  for (const std::size_t feature : {0U, 1U}) {
    const Land read = land("across_antimeridian.geojson", feature);
    REQUIRE(read.features == 2);
    REQUIRE(std::abs(read.datum.lon_deg) == Approx(180));
    REQUIRE(read.datum.lat_deg == Approx(-16.801));
    REQUIRE(area_m2(read.field) == Approx(quad_m2(-16.801, 0.002, 0.004)).epsilon(1e-6));
  }
  REQUIRE(land("across_antimeridian.geojson", 1).stated_area == hectares(9.4));
}

TEST_CASE("Projected coordinates come to the ground scale of their place") {
  const Land read = land("utm32.wkt", 0);
  REQUIRE(read.features == 3);
  // 300 m x 200 m on the central meridian of UTM, where 1 m on the ground is 0.9996 m on the map
  REQUIRE(area_m2(read.field) == Approx(300 * 200 / (0.9996 * 0.9996)).epsilon(1e-6));
  REQUIRE(area_m2(land("utm32.wkt", 2).field) == Approx(5000 / (0.9996 * 0.9996)).epsilon(1e-6));
}

TEST_CASE("GML axes follow the form of the CRS name: latitude first in a URN") {
  const Land urn = land("gml3_latitude_first.gml", 0);
  REQUIRE(urn.features == 2);
  REQUIRE(urn.name == "north");
  REQUIRE(urn.stated_area == hectares(6.15));
  const Land plain = land("gml3_latitude_first.gml", 1);
  REQUIRE(plain.name == "short form");
  for (const Land& read : {urn, plain}) {
    REQUIRE(read.datum.lat_deg == Approx(51.781));
    REQUIRE(read.datum.lon_deg == Approx(4.262));
    REQUIRE(area_m2(read.field) == Approx(quad_m2(51.781, 0.002, 0.004)).epsilon(1e-6));
  }
}

// A field near Sydney: latitudes from -33.802, longitudes from 151.200. The wrong way round, its
// latitude would be off the globe.
std::string sydney(const std::string& srs_name, bool is_latitude_first) {
  const double corners[][2] = {
      {-33.802, 151.2}, {-33.802, 151.204}, {-33.8, 151.204}, {-33.8, 151.2}, {-33.802, 151.2}};
  std::string places;
  for (const auto& [lat, lon] : corners) {
    places += is_latitude_first ? fmt::format("{} {} ", lat, lon) : fmt::format("{} {} ", lon, lat);
  }
  return fmt::format(
      "<Polygon{}><exterior><LinearRing><posList>{}</posList></LinearRing></exterior></Polygon>",
      srs_name.empty() ? "" : " srsName=\"" + srs_name + "\"", places);
}

TEST_CASE("Each form of a CRS name has its order of axes, and the other one is refused") {
  const std::pair<const char*, bool> forms[] = {
      {"EPSG:4326", false},
      {"http://www.opengis.net/gml/srs/epsg.xml#4326", false},
      {"urn:ogc:def:crs:OGC:1.3:CRS84", false},
      {"urn:ogc:def:crs:EPSG::4326", true},
      {"http://www.opengis.net/def/crs/EPSG/0/4326", true}};
  for (const auto& [srs_name, is_latitude_first] : forms) {
    INFO(srs_name);
    const auto read = read_land(LandFile{"a", sydney(srs_name, is_latitude_first)});
    INFO((read ? "" : text(read.error())));
    REQUIRE(read);
    CHECK(read->datum.lat_deg == Approx(-33.801));
    CHECK(read->datum.lon_deg == Approx(151.202));
    CHECK(area_m2(read->field) == Approx(quad_m2(-33.801, 0.002, 0.004)).epsilon(1e-6));
    const std::string other = refusal_of(sydney(srs_name, !is_latitude_first));
    CHECK(other.find("coordinates must come to a place on the globe") != std::string::npos);
    CHECK(other.find(is_latitude_first ? "latitude first" : "longitude first") !=
          std::string::npos);
  }
}

TEST_CASE("GML without a CRS is refused") {
  CHECK(refusal_of(sydney("", false)) == "a: must say its CRS in a srsName (got none)");
}

TEST_CASE("A GAOS parcel is its boundary, with its hectares; its edges are not counted") {
  const Land parcel = land("gaos_parcel.xml", 0);
  REQUIRE(parcel.features == 1);
  REQUIRE(parcel.name == "gaos_parcel");  // it has none of its own
  REQUIRE(parcel.stated_area == hectares(6.15));
  REQUIRE(area_m2(parcel.field) == Approx(quad_m2(51.781, 0.002, 0.004)).epsilon(1e-6));
}

TEST_CASE("An ISOXML part field keeps its holes, loses its obstacles, and ignores its zones") {
  const Land pond = land("taskdata/TASKDATA.XML", 0);
  REQUIRE(pond.features == 2);  // one has no boundary, one stands in the external file
  REQUIRE(pond.name == "Pond & zones");
  REQUIRE(pond.stated_area == square_metres(55000));
  REQUIRE(pond.field.holes.size() == 2);
  const double expected_m2 = quad_m2(51.781, 0.002, 0.004) - quad_m2(51.78075, 0.0005, 0.001) -
                             quad_m2(51.78125, 0.0001, 0.0001);
  REQUIRE(area_m2(pond.field) == Approx(expected_m2).epsilon(1e-6));
  const Land external = land("taskdata/TASKDATA.XML", 1);
  REQUIRE(external.name == "External");
  REQUIRE(external.stated_area == square_metres(30000));
}

TEST_CASE("A file that is no field is refused in one line, with the rule and what is there") {
  CHECK(refusal("absent.kml") == "absent.kml: must be a readable file (got nothing)");
  CHECK(refusal("broken/empty.geojson") ==
        "broken/empty.geojson: must hold a field (got an empty file)");
  CHECK(refusal("broken/no_feature.geojson") ==
        "broken/no_feature.geojson: must hold a polygon (got no geometry)");
  CHECK(refusal("broken/point.geojson") ==
        "broken/point.geojson: must hold a polygon (got only points or lines, 1 in number)");
  CHECK(refusal("broken/line.wkt") ==
        "broken/line.wkt: must hold a polygon (got only points or lines, 1 in number)");
  CHECK(refusal("broken/truncated.geojson").find("must be a sound GeoJSON file") !=
        std::string::npos);
  CHECK(refusal("broken/truncated.wkt").find("must be a sound WKT geometry") != std::string::npos);
  CHECK(refusal("broken/truncated.kml").find("must be sound XML") != std::string::npos);
  CHECK(refusal("broken/garbage.gpkg").find("must be a sound GPKG file") != std::string::npos);
  CHECK(refusal("broken/garbage.shp").find("must be a sound ESRI Shapefile file") !=
        std::string::npos);
  CHECK(refusal("broken/record_leads_backwards.shp").find("must be a sound ESRI Shapefile") !=
        std::string::npos);
  for (const std::string file : {"broken/picture.png", "broken/table.csv"}) {
    CHECK(refusal(file).find("must be GeoJSON, KML, WKT, GML, shapefile, GeoPackage or ISOXML") !=
          std::string::npos);
  }
  CHECK(refusal("broken/flat.geojson").find("must enclose an area") != std::string::npos);
  CHECK(refusal("broken/a_country.geojson").find("must be at most 200 km wide") !=
        std::string::npos);
  CHECK(refusal("broken/at_the_pole.geojson").find("within 85 degrees of the equator") !=
        std::string::npos);
  CHECK(refusal("broken/no_boundary.xml").find("a boundary (PLN of type 1)") != std::string::npos);
  CHECK(
      refusal("broken/latitude_a_word.xml") ==
      "broken/latitude_a_word.xml: PNT must have a latitude C and a longitude D (got north, 4.2)");
}

TEST_CASE("Bare metres, unknown CRS and a CRS from a network have no place on the globe") {
  CHECK(refusal("bare_metres.wkt") ==
        "bare_metres.wkt: coordinates must be degrees on the globe, or have a CRS (got 700, 0 "
        "in WGS84 without a CRS stated, longitude first)");
  CHECK(refusal("broken/bare_metres.geojson") ==
        "broken/bare_metres.geojson: coordinates must come to a place on the globe by their CRS "
        "(got 700, 0 in WGS 84 (EPSG:4326), longitude first)");
  CHECK(refusal("broken/crs_from_network.geojson") ==
        "broken/crs_from_network.geojson: crs must be one that PROJ knows, or left out for WGS84 "
        "(got no name)");
  const std::pair<const char*, std::string> unknown[] = {
      {"null", "null"},
      {R"({"type": "name", "properties": {"name": "EPSG:999999"}})", "EPSG:999999"},
      {R"({"type": "link", "properties": {"href": "http://example.org/crs"}})", "no name"}};
  for (const auto& [crs, got] : unknown) {
    CHECK(
        refusal_of(fmt::format(R"({{"type": "Feature", "crs": {}, "properties": {{}}, "geometry": )"
                               R"({{"type": "Polygon", "coordinates": [[[4, 51], [4.01, 51], )"
                               R"([4.01, 51.01], [4, 51]]]}}}})",
                               crs)) ==
        "a: crs must be one that PROJ knows, or left out for WGS84 (got " + got + ")");
  }
  CHECK(refusal_of("POLYGON ((0 0, 100 0, 100 50, 0 50, 0 0))") ==
        "a: must be at most 200 km wide; bare metres need a CRS (got 100 x 50 degrees in WGS84 "
        "without a CRS stated, longitude first)");
  CHECK(refusal_of("SRID=4326;POLYGON ((4 51, 8 51, 8 52, 4 52, 4 51))") ==
        "a: must be at most 200 km wide (got 4 x 1 degrees in WGS 84 (EPSG:4326), longitude "
        "first)");
  CHECK(refusal("broken/unknown_srid.wkt").find("SRID must be a known EPSG code") !=
        std::string::npos);
}

TEST_CASE("An external entity is not fetched") {
  CHECK(refusal("broken/external_entity.gml").find("root:") == std::string::npos);
}

TEST_CASE("Obstacles are read into the frame of the field") {
  const LocalFrame frame{{.lat_deg = 51.781, .lon_deg = 4.262}};
  const auto obstacles = read_obstacles(folder + "obstacles.geojson", frame);
  REQUIRE(obstacles);
  REQUIRE(obstacles->size() == 3);
  CHECK((*obstacles)[2].obstacle.id == "pond");
  CHECK((*obstacles)[2].obstacle.outline.size() == 4);
  CHECK((*obstacles)[0].obstacle.id == "tree1");
  CHECK((*obstacles)[0].obstacle.radius == metres(3));
  CHECK(distance((*obstacles)[0].obstacle.center, at_m(0, 0)).base() < 1e-6);
  CHECK((*obstacles)[1].obstacle.id == "obstacle2");
  // 0.0001 degrees of longitude at 51.781 N: N cos(lat) * 0.0001 degrees
  const double east_m = ground::prime_vertical_radius_m(51.781) *
                        std::cos(51.781 * ground::degree) * 0.0001 * ground::degree;
  CHECK((*obstacles)[1].obstacle.center.x.base() == Approx(east_m).epsilon(1e-6));
  CHECK(!read_obstacles(folder + "broken/point.geojson", frame));  // no radius
  CHECK(!read_obstacles(folder + "two_fields.kml", frame));
  CHECK((*obstacles)[1].feature == "feature 2");
  CHECK(!(*obstacles)[1].seen_within);
}

TEST_CASE("Obstacles may be unknown to the plan, and errors name their feature") {
  const LocalFrame frame{{.lat_deg = 51.781, .lon_deg = 4.262}};
  const auto read = [&](const std::string& properties) {
    const LandFile file{.path = "file",
                        .bytes = R"({"type": "FeatureCollection", "features": [
          {"type": "Feature", "properties": {"radius_m": 1},
           "geometry": {"type": "Point", "coordinates": [4.262, 51.781]}},
          {"type": "Feature", "properties": {)" +
                                 properties + R"(},
           "geometry": {"type": "Point", "coordinates": [4.2621, 51.781]}}]})"};
    return read_obstacles(file, frame);
  };
  const auto unknown = read(R"("id": "elm", "radius_m": 2, "seen_within_m": 25, "appears_s": 60)");
  REQUIRE(unknown);
  CHECK((*unknown)[1].seen_within == metres(25));
  CHECK((*unknown)[1].appears == seconds(60.0));
  CHECK((*unknown)[1].feature == "feature 2 (elm)");

  const auto no_radius = read(R"("name": "elm")");
  REQUIRE(!no_radius);
  CHECK(no_radius.error().rule == "radius_m must be a number > 0");
  CHECK(no_radius.error().value == "feature 2 (elm): none");
  const auto blind = read(R"("radius_m": 2, "seen_within_m": "far")");
  REQUIRE(!blind);
  CHECK(blind.error().rule == "seen_within_m must be a number > 0");
  CHECK(blind.error().value == "feature 2: far");
  const auto truth = read(R"("radius_m": 2, "seen_within_m": true)");
  REQUIRE(!truth);
  CHECK(truth.error().rule == "seen_within_m must be a number > 0");

  // Two letters too few; another property, of whoever else uses the file, is nobody's concern.
  const auto slip = read(R"("id": "elm", "radius_m": 2, "seen_within": 25)");
  REQUIRE(!slip);
  CHECK(slip.error().rule == "properties must be spelt as seen_within_m is");
  CHECK(slip.error().value == "feature 2 (elm): seen_within");
  CHECK(read(R"("radius_m": 2, "species": "Ulmus")"));
}

}  // namespace
