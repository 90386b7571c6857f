#include "app/results/summary.hpp"

#include "app/results/expectations.hpp"
#include "tests/app/results/small_mission.hpp"

#include <catch2/catch.hpp>

namespace furrow::app {
namespace {

TEST_CASE("summary: a plan's figures are its forecasts", "[app]") {
  const Result r = summary(small_plan());

  CHECK(r.completed);
  CHECK(r.field.area_m2 == 48.0);         // 6 * 8
  CHECK(r.field.strip_length_m == 18.0);  // 3 strips of 6 m between end centres
  CHECK(r.field.cells == 12);
  CHECK(r.coverage.covered_m2 == 48.0);
  CHECK(r.coverage.missed_m2 == 0.0);
  CHECK(r.fleet.makespan_s == Approx(74 + 7.615773105863909));
  CHECK(r.fleet.gap == Approx(81.615773105863909 / 80 - 1));
  CHECK(r.fleet.spray_s == 20.0);  // 8 + 6 + 6
  CHECK(r.fleet.route_m == 20.0);
  // Ferries: 7.615773 home and out again, sqrt(10) home, sqrt(74) home.
  CHECK(r.fleet.ferry_m == Approx(2 * 7.615773105863909 + 3.1622776601683795 + 8.602325267042627));
  CHECK(r.solver.non_spray_s == Approx(67.615773105863909));
  CHECK(r.solver.optimum_s == r.solver.non_spray_s);
  CHECK(r.solver.gap == 0.0);
  CHECK(r.solver.fill_s == 44.0);

  REQUIRE(r.uavs[0].sorties.size() == 2);
  const SortieFigures& out = r.uavs[0].sorties[0];
  CHECK(out.round_trip_m == Approx(2 * 7.615773105863909));
  CHECK(out.fill == Approx(0.6));  // 6 m of the 10 m that a tank lasts
  CHECK(out.bay == 1);
  CHECK(r.uavs[0].sorties[1].began_s == Approx(out.ready_s));
  CHECK(r.uavs[0].sorties[1].round_trip_m == 0.0);
  CHECK(r.stations[0].swaps == 1);
  CHECK(r.stations[0].filled_l == Approx(3.0));  // 0.6 of 5 L
  CHECK(r.stations[0].bays[0].busy_s == Approx(60.0));
  // Twelve cells of 4 m2 are wetted once. A tank of 5 L lasts 10 m of 2 m: 0.25 L/m2.
  CHECK(r.footprint.wetted_m2 == Approx(48));
  CHECK(r.footprint.missed_m2 == Approx(0).margin(1e-9));
  CHECK(r.footprint.overlap_m2 == Approx(0).margin(1e-9));
  CHECK(r.fleet.rate_l_ha == Approx(2500));
  CHECK(r.fleet.sprayed_l == Approx(12));
  CHECK(r.fleet.repeated_l == Approx(0).margin(1e-9));
  CHECK(r.fleet.outside_l == Approx(0).margin(1e-9));
  REQUIRE(r.batteries.size() == 3);
  CHECK(r.batteries[1].used == 0.114);
}

TEST_CASE("summary: rows and ways that are too steep for the heights to be kept are a warning",
          "[app]") {
  // A hill of 2 m in the middle of the strips: much steeper than 0.1 m/s climbs at full speed.
  MissionRecord record = small_plan();
  const planner::AnalyticTerrain hill{.base = {},
                                      .peaks = {{at_m(3, 4), metres(2), metres(2), metres(2)}}};
  const auto warnings_at = [&](Speed vertical, double slowest) {
    const planner::HeightRule rule{.climb = vertical, .descent = vertical, .slowest = slowest};
    const planner::Relief relief{{.ground = hill, .rule = rule, .keep_out = {}},
                                 {at_m(-10, -10), at_m(20, 20)}};
    record.plan.route.ferries = small_plan().plan.route.ferries.over_ground(relief);
    return summary(record).warnings;
  };
  const auto steep = warnings_at(metres_per_second(0.1), 1);
  REQUIRE(steep.size() == 2);
  CHECK_THAT(steep[0], Catch::Contains(" m of rows are steeper than aircraft climb or descend at "
                                       "their least speed; the spray height is not kept there, "
                                       "first at ("));
  CHECK_THAT(steep[1], Catch::Contains(" m of ways between rows, way points and stations are "));
  CHECK(warnings_at(metres_per_second(5), 0.25).empty());
}

TEST_CASE("summary: what was flown counts by closed grants, once each", "[app]") {
  const Result r = summary(small_flight());

  CHECK_FALSE(r.completed);
  CHECK(r.coverage.covered_m2 == 44.0);   // 11 cells of 4 m2
  CHECK(r.coverage.missed_m2 == 4.0);     // cell 11 has no proof
  CHECK(r.coverage.uncertain_m2 == 4.0);  // yet was passed with the valve open
  CHECK(r.coverage.abandoned_m2 == 4.0);
  CHECK(r.coverage.repeated_m2 == 0.0);
  CHECK(r.fleet.makespan_s == 85.0);
  CHECK(r.fleet.spray_s == 20.0);  // 6 + 8 + 6 with the valve open
  // UAV 1: home 8 to 12, waits 3, in the bay 60, takes off at 75 and sprays from 79.
  CHECK(r.uavs[0].non_spray_s == 4 + 3 + 60 + 4);
  CHECK(r.fleet.queue_wait_s == 3.0);
  // Home from (3, 7), out again, and home from (3, 1); of UAV 2 no way is on record.
  CHECK(r.fleet.ferry_m == Approx(2 * 7.615773105863909 + 3.1622776601683795));
  // Tracks as they are: straight from (1, 1) to (3, 7), and two strips of 6 m.
  CHECK(r.fleet.route_m == Approx(12 + std::sqrt(2 * 2 + 6 * 6)));
  // UAV 2 never reported its sortie; its valve closed at 6 s.
  CHECK(r.uavs[1].sorties.empty());
  CHECK(r.uavs[1].spray_ended_s == 6.0);
  CHECK(r.real_time_factor == 44.0);  // 88 s in 2 s
  // The swath of UAV 2 reaches 0.5 m over the eastern edge on 8 m.
  CHECK(r.coverage.outside_m2 == Approx(4.0));
  // sqrt((1.0 + 0) / 12) over 4 + 5 + 3 samples.
  CHECK(r.deviation.truth.rms_m == Approx(0.28867513459481287));
  CHECK(r.deviation.truth.max_m == 0.5);
  CHECK(r.uavs[1].deviation.fix.rms_m == Approx(0.1));
}

TEST_CASE("summary: an empty log of a flight is no error", "[app]") {
  MissionRecord record = small_flight();
  record.log.clear();
  const Result r = summary(record);

  CHECK_FALSE(r.completed);
  CHECK(r.coverage.missed_m2 == 48.0);
  CHECK(r.fleet.makespan_s == 0.0);
  CHECK(r.log.digest == "cbf29ce484222325");  // FNV-1a of nothing
}

TEST_CASE("summary: boots do not change the digest, and every other field does", "[app]") {
  MissionRecord record = small_flight();
  const std::string before = summary(record).log.digest;
  std::get<WorkReport>(record.log[0].body).boot = BootId{99};
  CHECK(summary(record).log.digest == before);
  std::get<WorkReport>(record.log[0].body).closures[0].sprayed = 2;
  CHECK(summary(record).log.digest != before);
}

TEST_CASE("summary: the digest tells the windows of aircraft", "[app]") {
  MissionRecord record = small_flight();
  record.log.push_back(
      {node(AgentId{1}), 1, Instant{}, AgentInfo{AgentId{1}, BootId{1}, record.scenario.uavs[0]}});
  Vehicle& uav = std::get<AgentInfo>(record.log.back().body).vehicle;
  const std::string always = summary(record).log.digest;
  uav.available_from = seconds(60);
  const std::string later = summary(record).log.digest;
  uav.available_until = seconds(600);
  CHECK(later != always);
  CHECK(summary(record).log.digest != later);
}

TEST_CASE("summary: an expectation is met within its bounds and missed outside", "[app]") {
  MissionRecord record = small_plan();
  record.scenario.expectations = {{"completed", 1.0, 1.0},    {"missed_m2", {}, 0.0},
                                  {"route_m", 20.0, {}},      {"encounters", 4.0, {}},
                                  {"covered_m2", 10.0, 47.0}, {"yield_kg", {}, 1.0}};
  const Result r = summary(record);

  REQUIRE(r.expectations.size() == 6);
  for (const std::size_t i : {0u, 1u, 2u}) CHECK(r.expectations[i].met);
  for (const std::size_t i : {3u, 4u, 5u}) CHECK_FALSE(r.expectations[i].met);
  CHECK(r.expectations[3].message == "encounters is 0, expected at least 4");
  CHECK(r.expectations[4].message == "covered_m2 is 48, expected 10 to 47");
  CHECK(r.expectations[5].message == "yield_kg: this result has no such figure");
  CHECK_FALSE(r.expectations[5].value);
  CHECK_FALSE(all_met(r));
}

TEST_CASE("summary: the gap of a mission that is not completed meets no expectation", "[app]") {
  MissionRecord record = small_flight();  // its return points are proven: a gap of another kind
  record.scenario.expectations = {{"gap", {}, 10.0}};
  const Result r = summary(record);
  REQUIRE(r.solver.gap == 0.0);
  CHECK_FALSE(r.expectations[0].met);
}

}  // namespace
}  // namespace furrow::app
