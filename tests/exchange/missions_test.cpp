#include "exchange/missions.hpp"

#include "exchange/gdal.hpp"
#include "tests/exchange/ground.hpp"

#include <catch2/catch.hpp>

#include <cpl_vsi.h>
#include <nlohmann/json.hpp>
#include <ogrsf_frmts.h>

#include <sstream>

namespace {

using namespace furrow;
using namespace furrow::exchange;

const LocalFrame& frame() {
  static const LocalFrame frame{{.lat_deg = 51.781, .lon_deg = 4.262}};
  return frame;
}

// Two strips of 100 m with the valve closed on the way between them.
SortieTrack track() {
  return {.uav = AgentId{2},
          .sortie = 3,
          .home = at_m(-10, -10),
          .landing = at_m(-20, 5),
          .points = {{at_m(0, 0), true, {}, metres(3.5)},
                     {at_m(100, 0), false, {}, metres(3.5)},
                     {at_m(100, 2), true, {}, metres(3.5)},
                     {at_m(0, 2), false, {}, metres(3.5)}},
          .take_off = metres(3.5),
          .spray_speed = metres_per_second(3),
          .ferry_speed = metres_per_second(6)};
}

/// A file as its reader sees it: places between take-off and landing, and what the valve does.
struct Leg {
  GeoPoint to;
  bool is_spraying;  // on the way there
};

// The course of track(): five ways, of which the second and the fourth are sprayed.
void check_course(const std::vector<Leg>& legs) {
  const std::vector<FieldPoint> places{at_m(0, 0), at_m(100, 0), at_m(100, 2), at_m(0, 2),
                                       at_m(-20, 5)};
  const std::vector<bool> sprayed{false, true, false, true, false};
  REQUIRE(legs.size() == places.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const GeoPoint expected = frame().to_wgs84(places[i]);
    CHECK(std::abs(legs[i].to.lon_deg - expected.lon_deg) < 1e-7);
    CHECK(std::abs(legs[i].to.lat_deg - expected.lat_deg) < 1e-7);
    CHECK(legs[i].is_spraying == sprayed[i]);
  }
}

/// A minimal autopilot: follows items as MAVLink defines them.
struct Autopilot {
  std::vector<Leg> legs = {};
  std::vector<double> speeds_mps = {};
  int switched_on = 0, switched_off = 0;
  bool is_spraying = false, is_up = false, has_landed = false;

  void execute(int command, const std::vector<double>& params) {
    REQUIRE(params.size() == 7);
    REQUIRE(!has_landed);
    switch (command) {
      case 22: is_up = true; break;
      case 16:
        REQUIRE(is_up);
        CHECK(params[6] == 3.5);
        legs.push_back({{params[5], params[4]}, is_spraying});
        break;
      case 178: speeds_mps.push_back(params[1]); break;
      case 216:
        REQUIRE(is_spraying != (params[0] == 1));
        is_spraying = params[0] == 1;
        ++(is_spraying ? switched_on : switched_off);
        break;
      case 21:
        CHECK(params[6] == 0);
        legs.push_back({{params[5], params[4]}, is_spraying});
        has_landed = true;
        break;
      default: FAIL("an unknown command: " << command);
    }
  }
  void check() const {
    check_course(legs);
    CHECK(has_landed);
    CHECK(switched_on == 2);
    CHECK(switched_off == 2);
    CHECK(speeds_mps == std::vector<double>{6, 3, 6, 3, 6});
  }
};

TEST_CASE("A QGroundControl plan flies the sortie with the valve in pairs of on and off") {
  const auto plan = nlohmann::json::parse(mission_file(track(), frame(), MissionFormat::qgc_plan));
  CHECK(plan.at("fileType") == "Plan");
  CHECK(plan.at("version") == 1);
  CHECK(plan.at("geoFence").at("version") == 2);
  CHECK(plan.at("rallyPoints").at("version") == 2);
  const auto& mission = plan.at("mission");
  CHECK(mission.at("version") == 2);
  const GeoPoint home = frame().to_wgs84(track().home);
  CHECK(std::abs(mission.at("plannedHomePosition").at(0).get<double>() - home.lat_deg) < 1e-7);
  CHECK(std::abs(mission.at("plannedHomePosition").at(1).get<double>() - home.lon_deg) < 1e-7);
  Autopilot autopilot;
  int id = 1;
  for (const auto& item : mission.at("items")) {
    CHECK(item.at("type") == "SimpleItem");
    CHECK(item.at("doJumpId") == id++);
    CHECK(item.at("autoContinue") == true);
    const int command = item.at("command");
    const bool is_place = command == 16 || command == 21 || command == 22;
    CHECK(item.at("frame") == (is_place ? 3 : 2));
    autopilot.execute(command, item.at("params"));
  }
  autopilot.check();
}

TEST_CASE("An ArduPilot waypoint file starts with home and flies the sortie") {
  std::istringstream file{mission_file(track(), frame(), MissionFormat::waypoints)};
  std::string line;
  std::getline(file, line);
  REQUIRE(line == "QGC WPL 110");
  Autopilot autopilot;
  for (int expected = 0; std::getline(file, line); ++expected) {
    std::istringstream fields{line};
    int number = -1, current = -1, mav_frame = -1, command = -1, goes_on = -1;
    std::vector<double> params(7);
    fields >> number >> current >> mav_frame >> command;
    for (double& param : params) fields >> param;
    fields >> goes_on;
    REQUIRE(fields);
    CHECK(number == expected);
    CHECK(current == (number == 0 ? 1 : 0));
    CHECK(goes_on == 1);
    if (number == 0) {
      const GeoPoint home = frame().to_wgs84(track().home);
      CHECK(std::abs(params[4] - home.lat_deg) < 1e-7);
      CHECK(std::abs(params[5] - home.lon_deg) < 1e-7);
    } else {
      autopilot.execute(command, params);
    }
  }
  autopilot.check();
}

// The ways along one line.
void append_legs(const OGRLineString& line, bool is_spraying, std::vector<Leg>& legs) {
  CHECK(line.getZ(0) == 3.5);
  for (int i = 1; i < line.getNumPoints(); ++i) {
    legs.push_back({{line.getX(i), line.getY(i)}, is_spraying});
  }
}

// GeoJSON and KML as OGR reads them.
std::vector<Leg> legs_by_ogr(const std::string& content, const std::string& name,
                             bool (*is_sprayed)(OGRFeature&)) {
  const GdalScope gdal;
  RegisterOGRKML();
  std::string bytes = content;
  VSIFCloseL(VSIFileFromMemBuffer(name.c_str(), reinterpret_cast<GByte*>(bytes.data()),
                                  bytes.size(), FALSE));
  std::vector<Leg> legs;
  {
    const std::unique_ptr<GDALDataset> file{GDALDataset::Open(name.c_str(), GDAL_OF_VECTOR)};
    REQUIRE(file);
    for (OGRLayer* layer : file->GetLayers()) {
      for (const auto& feature : *layer) {
        append_legs(*feature->GetGeometryRef()->toLineString(), is_sprayed(*feature), legs);
      }
    }
  }
  VSIUnlink(name.c_str());
  return legs;
}

TEST_CASE("GeoJSON holds one line per stretch of one valve state, from home to the landing") {
  const auto legs =
      legs_by_ogr(mission_file(track(), frame(), MissionFormat::geojson), "/vsimem/track.geojson",
                  [](OGRFeature& f) { return f.GetFieldAsInteger("spraying") == 1; });
  check_course(legs);
}

TEST_CASE("KML holds one line per stretch of one valve state, from home to the landing") {
  const auto legs =
      legs_by_ogr(mission_file(track(), frame(), MissionFormat::kml), "/vsimem/track.kml",
                  [](OGRFeature& f) { return f.GetFieldAsString("Name") == std::string{"spray"}; });
  check_course(legs);
}

TEST_CASE("CSV holds a row for every point, from home to the landing") {
  std::istringstream file{mission_file(track(), frame(), MissionFormat::csv)};
  std::string line;
  std::getline(file, line);
  REQUIRE(line == "uav,sortie,point,lon_deg,lat_deg,altitude_m,spraying,speed_mps,width_m");
  std::vector<Leg> legs;
  bool is_spraying = false;
  for (int row = 0; std::getline(file, line); ++row) {
    std::vector<double> cells;
    std::istringstream rest{line};
    for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(std::stod(cell));
    REQUIRE(cells.size() == 8);
    CHECK(cells[0] == 2);
    CHECK(cells[1] == 3);
    CHECK(cells[2] == row);
    CHECK(cells[5] == 3.5);
    CHECK(cells[7] == (cells[6] == 1 ? 3 : 6));
    if (row > 0) legs.push_back({{cells[3], cells[4]}, is_spraying});
    is_spraying = cells[6] == 1;
  }
  check_course(legs);
}

TEST_CASE("GeoJSON and CSV tell where only a part of the boom is open, and how wide") {
  SortieTrack narrow = track();
  narrow.points[2].width = metres(1.5);
  const auto file =
      nlohmann::json::parse(mission_file(narrow, frame(), MissionFormat::geojson)).at("features");
  REQUIRE(file.size() == 5);  // ferry, spray, ferry, narrow spray, ferry
  CHECK_FALSE(file[1].at("properties").contains("width_m"));
  CHECK(file[3].at("properties").at("width_m") == 1.5);

  std::istringstream rows{mission_file(narrow, frame(), MissionFormat::csv)};
  std::string row;
  for (int i = 0; i < 5; ++i) std::getline(rows, row);  // the header, home, three points
  CHECK(row.ends_with(",1,3,1.5"));
  for (const auto format :
       {MissionFormat::qgc_plan, MissionFormat::waypoints, MissionFormat::kml}) {
    CHECK_FALSE(tells_width(format));
  }
}

TEST_CASE("A valve still open at the last point is closed there") {
  SortieTrack open = track();
  open.points.back().is_spraying = true;
  for (const char* name : {"qgc-plan", "waypoints", "geojson", "kml", "csv"}) {
    const auto format = mission_format(name);
    REQUIRE(format);
    CHECK(mission_file(open, frame(), *format) == mission_file(track(), frame(), *format));
  }
}

TEST_CASE("Files are named by aircraft, sortie and format") {
  CHECK(file_name(track(), MissionFormat::qgc_plan) == "uav2_sortie3.plan");
  CHECK(file_name(track(), MissionFormat::waypoints) == "uav2_sortie3.waypoints");
  CHECK(file_name(track(), MissionFormat::kml) == "uav2_sortie3.kml");
  CHECK(!mission_format("xlsx"));
}

TEST_CASE("Only names of mission files are told as such") {
  for (const char* name : {"qgc-plan", "waypoints", "geojson", "kml", "csv"}) {
    const auto format = mission_format(name);
    REQUIRE(format);
    CHECK(format_of_file(file_name(track(), *format)) == format);
  }
  for (const char* name :
       {"", "uav", "uav1_sortie.csv", "uav_sortie1.csv", "uav1_sortie1.csv.bak", "uav1_sortie1",
        "my_uav1_sortie1.csv", "uav1_sortie1x.kml", "sorties.csv"}) {
    CHECK(!format_of_file(name));
  }
}

}  // namespace
