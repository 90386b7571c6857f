#include "app/results/events_jsonl.hpp"
#include "app/results/plan_geojson.hpp"
#include "app/results/report/report_html.hpp"
#include "app/results/report/simplify.hpp"
#include "app/results/result_json.hpp"
#include "app/results/sorties_csv.hpp"
#include "app/results/summary.hpp"
#include "app/results/terminal.hpp"
#include "app/results/write_results.hpp"
#include "tests/app/results/small_mission.hpp"

#include "app/results/report/height_charts.hpp"
#include <algorithm>

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace furrow::app {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys(const Json& json) {
  std::vector<std::string> names;
  for (const auto& [key, value] : json.items()) names.push_back(key);
  return names;
}

// Names of tags in order of opening; fails where one closes that is not open.
bool is_balanced(const std::string& page) {
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
    if (page[at + 1] == '!') continue;
    const std::size_t close = page.find('>', at);
    if (close == std::string::npos) return false;
    const bool is_end = page[at + 1] == '/';
    const std::size_t first = at + (is_end ? 2 : 1);
    const std::string tag = page.substr(first, page.find_first_of(" >/\n", first) - first);
    if (page[close - 1] == '/') continue;
    if (!is_end) {
      open.push_back(tag);
    } else {
      if (open.empty() || open.back() != tag) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

TEST_CASE("result_json: has the agreed keys in the agreed order", "[app]") {
  const Json json = Json::parse(result_json(summary(small_flight())));

  CHECK(keys(json) == std::vector<std::string>{"version",  "scenario",    "seed",       "mode",
                                               "partial",  "completed",   "field",      "datum",
                                               "sweep",    "coverage",    "footprint",  "fleet",
                                               "uavs",     "batteries",   "solver",     "deviation",
                                               "stations", "warnings",    "laws",       "log",
                                               "timing",   "faults",      "separation", "clearance",
                                               "operator", "expectations"});
  const auto sortie = keys(json["uavs"][0]["sorties"][0]);
  const std::vector<std::string> agreed{
      "start_m",      "return_m",       "spray_m", "round_trip_m", "flight_s",
      "battery_used", "battery_swap_s", "fill_s",  "wait_s",       "bay"};
  CHECK(std::equal(agreed.begin(), agreed.end(), sortie.begin()));
  CHECK(json["uavs"][0]["sorties"][0]["return_m"] == Json::array({3.0, 7.0}));
  CHECK(json["uavs"][0]["sorties"][0]["round_trip_m"] == 15.231546);  // 2 sqrt(58), to 1e-6
  CHECK(json["uavs"][0]["sorties"][1]["bay"].is_null());
  CHECK(json["mode"] == "sim");
}

TEST_CASE("result_json: modes and timing alone make a difference", "[app]") {
  MissionRecord record = small_flight();
  Json one = Json::parse(result_json(summary(record)));
  record.mode = Mode::run;
  record.timing = {.plan_wall_s = 9, .run_wall_s = 8, .solver_wall_s = 7};
  Json other = Json::parse(result_json(summary(record)));
  for (Json* json : {&one, &other}) {
    json->erase("mode");
    json->erase("timing");
    (*json)["solver"].erase("wall_s");
  }
  CHECK(one.dump() == other.dump());
}

TEST_CASE("sorties_csv: a header, a line per sortie, CRLF", "[app]") {
  const std::string csv = sorties_csv(summary(small_plan()));

  CHECK(csv.starts_with("uav,sortie,start_x_m,start_y_m,return_x_m,return_y_m,spray_m,"));
  std::istringstream lines{csv};
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    CHECK(line.back() == '\r');
    CHECK(std::count(line.begin(), line.end(), ',') == 22);  // 23 columns
  }
  CHECK(count == 4);
}

TEST_CASE("events_jsonl: leaves heartbeats and flight records out", "[app]") {
  const std::string text = events_jsonl(small_flight().log);
  std::istringstream lines{text};
  std::vector<Json> all;
  for (std::string line; std::getline(lines, line);) all.push_back(Json::parse(line));

  // Of 10 messages 3 are flight records and one is the scheduler's heartbeat.
  REQUIRE(all.size() == 6);
  CHECK(all[0]["t_s"] == 6.0);
  CHECK(all[0]["from"] == "agent 2");
  CHECK(all[0]["topic"] == "work_report");
  CHECK(all[0]["closures"][0]["reason"] == "tank_low");
}

TEST_CASE("plan_geojson: holds the field, its strips and return points", "[app]") {
  const Json json = Json::parse(plan_geojson(small_plan()));

  CHECK(json["type"] == "FeatureCollection");
  CHECK(json["frame"]["unit"] == "metre");
  std::map<std::string, int> kinds;
  for (const Json& f : json["features"]) ++kinds[f["properties"]["kind"].get<std::string>()];
  CHECK(kinds == std::map<std::string, int>{
                     {"field", 1}, {"supply_station", 1}, {"strip", 3}, {"return_point", 1}});
  CHECK(json["features"][0]["geometry"]["coordinates"][0].size() == 5);  // closed
}

TEST_CASE("report_html: is well formed, whole in itself and escapes names", "[app]") {
  for (MissionRecord record : {small_plan(), small_flight()}) {
    record.scenario.name = "<b>5 & \"6\"";
    record.log.push_back({scheduler_node(), 2, Instant{Duration{90'000'000'000}},
                          Event{"agent_lost", "<script>alert(1)</script>"}});
    const std::string page = report_html(record, summary(record));

    CHECK(is_balanced(page));
    CHECK(page.find("://") == std::string::npos);
    CHECK(page.find("<script") == std::string::npos);
    CHECK(page.find("url(") == std::string::npos);
    CHECK(page.find("&lt;b&gt;5 &amp; &quot;6&quot;") != std::string::npos);
  }
}

TEST_CASE("report_html: how good a plan is, by its non-spray time, its last cell, or not known",
          "[app]") {
  const auto page = [](const Result& r) { return report_html(small_plan(), r); };
  Result r = summary(small_plan());
  CHECK(page(r).find("<b>Above the optimum</b><strong>0.00 %") != std::string::npos);
  r.solver.gap.reset();
  // 81.615773 s above 80 s.
  CHECK(page(r).find("<b>Above the bound</b><strong>2.02 %") != std::string::npos);
  r.fleet.lower_bound_s = 0;
  CHECK(page(r).find("<b>Optimality gap</b><strong>not known") != std::string::npos);
}

TEST_CASE("report_html: bears a flight without a log and a UAV without work", "[app]") {
  MissionRecord record = small_flight();
  record.log.clear();
  record.plan.uavs[1].cells = {12, 0};
  record.plan.uavs[1].strips = {3, 0};
  record.plan.uavs[1].solution = {};
  CHECK(is_balanced(report_html(record, summary(record))));
}

// Rises 1 m in 10 m eastwards.
planner::Surface ramp() {
  Raster raster{at_m(-100, -100), metres(100), 4, 4, {}};
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) raster.heights_m.push_back(static_cast<float>(10 * i));
  }
  return planner::Surface{raster};
}

TEST_CASE("report_html: a flight over terrain is shown from the side and with contours", "[app]") {
  MissionRecord record = small_flight();
  CHECK(report_html(record, summary(record)).find("Over the ground") == std::string::npos);
  record.plan.route.ferries = record.plan.route.ferries.over_ground({ramp(), {}, {}});
  const std::string page = report_html(record, summary(record));
  CHECK(is_balanced(page));
  CHECK(page.find("Over the ground") != std::string::npos);
  CHECK(page.find("contours every") != std::string::npos);
}

TEST_CASE("contours: lines of a ramp lie across it, one a step", "[app]") {
  // 10 m of rise over 100 m: lines 1 m apart, at every 10 m but where the rectangle begins.
  const Contours lines = contours(ramp(), {at_m(0, 0), at_m(100, 50)});
  CHECK(lines.step_m == 1);
  REQUIRE(!lines.pieces.empty());
  for (const auto& piece : lines.pieces) {
    REQUIRE(piece.size() == 2);
    CHECK(piece[0].x.base() == Approx(piece[1].x.base()));
    CHECK(std::remainder(piece[0].x.base(), 10) == Approx(0).margin(1e-4));
  }
  CHECK(contours(planner::Surface::level(metres(7)), {at_m(0, 0), at_m(9, 9)}).pieces.empty());
}

TEST_CASE("simplify: points close to the chain go, corners stay", "[app]") {
  const auto left = simplified({{0, 0}, {1, 0.1}, {2, 0}, {2, 5}, {2.1, 9}, {2, 10}}, 0.5);
  REQUIRE(left.size() == 3);
  CHECK(left[1].x == 2.0);
  CHECK(left[1].y == 0.0);
}

TEST_CASE("terminal: the summary fits into 100 columns and names what is missed", "[app]") {
  MissionRecord record = small_flight();
  record.scenario.expectations = {{"missed_m2", {}, 0.0}};
  record.violations = {{"L1", Instant{}, std::string(200, 'x')}};
  record.plan.bound = "farthest point";
  record.plan.yardsticks = scheduler::Yardsticks{};
  Result result = summary(record);
  result.fleet.planned_in_shared_air_s = 6000;
  result.separation = {
      .distance_m = 1, .encounters = 100, .near_s = 500, .closest_m = 0.5, .first_s = 1000};
  const std::string table = summary_table(result);

  std::istringstream lines{table};
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
  CHECK(table.find("missed: missed_m2 is 4, expected at most 0") != std::string::npos);
  CHECK(table.find("broken: L1") != std::string::npos);
}

TEST_CASE("terminal: the progress bar is drawn ten times a second and on terminals only", "[app]") {
  ProgressBar bar{200, true};
  CHECK(bar.clear().empty());
  const std::string drawn = bar.draw(50, 120.0, 2.0);
  CHECK(drawn.find(" 25.0 % done  2.0 min  60 x real time") != std::string::npos);
  CHECK(bar.draw(51, 121.0, 2.05).empty());
  CHECK_FALSE(bar.draw(51, 121.0, 2.11).empty());
  CHECK_FALSE(bar.clear().empty());
  CHECK(ProgressBar(200, false).draw(50, 120.0, 2.0).empty());
}

TEST_CASE("write_results: writes six files and leaves nothing else", "[app]") {
  namespace fs = std::filesystem;
  const fs::path dir = fs::temp_directory_path() / "furrow_write_results_test" / "deep";
  fs::remove_all(dir.parent_path());
  const MissionRecord record = small_plan();
  const auto written = write_results(dir, record, summary(record));

  REQUIRE(written);
  CHECK(written->size() == 6);
  CHECK(std::distance(fs::directory_iterator{dir}, fs::directory_iterator{}) == 6);
  std::ifstream file{dir / "result.json"};
  CHECK(Json::parse(file)["scenario"] == "small");

  // A file where the folder should be: the error names it.
  const auto failed = write_results(dir / "result.json", record, summary(record));
  REQUIRE_FALSE(failed);
  CHECK(text(failed.error()).find("result.json: ") != std::string::npos);
  fs::remove_all(dir.parent_path());
}

}  // namespace
}  // namespace furrow::app
