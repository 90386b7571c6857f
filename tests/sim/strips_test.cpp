// Strips in any direction, sprayed from end to end and joined by way points, flown by all parts.
#include "tests/sim/check_laws.hpp"
#include "tests/sim/one_station.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace furrow::sim {
namespace {

constexpr AgentId flyer{1};
constexpr double swath_m = 2.0;

// Walls leave a lane of no width between strip 1 and strip 2: up, then along y = 70, then down.
const std::vector<FieldPoint> lane{at_m(10, 60), at_m(10, 70), at_m(50, 70), at_m(50, 50)};

Vehicle vehicle() {
  Vehicle small = sim::vehicle(flyer);
  small.swath = metres(swath_m);
  small.spray_endurance = seconds(60);
  small.flight_endurance = seconds(400);
  return small;
}

// North, then (by the lane) south-east at 3:4, then west; lengths 50, 50 and 41.3 m.
// Along the last, 1.2 m of the boom are open.
planner::Route route() {
  std::vector<planner::Strip> strips{
      planner::end_strip({0, 1}, at_m(10, 10), lane.front(), {}),
      planner::end_strip({0, 1}, lane.back(), at_m(80, 10), {lane[1], lane[2]}),
      planner::end_strip({0, 1}, at_m(70, 5), at_m(28.7, 5), {})};
  strips.back().width = metres(1.2);
  return planner::end_to_end_route(metres(swath_m), std::move(strips));
}

// Returns after the 12th cell, in the middle of strip 1, and at the end of strip 2.
scheduler::FleetPlan plan() {
  scheduler::FleetPlan p{
      .route = route(), .work_direction_deg = 0, .uavs = {}, .makespan_s = 0, .lower_bound_s = 0};
  p.uavs = {uav_plan(p.route, vehicle(), {0, 3}, {11, end(p.route.strips[1].cells) - 1})};
  return p;
}

Facts facts() {
  return {.field = {.boundary = {at_m(0, 0), at_m(90, 0), at_m(90, 80), at_m(0, 80)},
                    .holes = {},
                    .obstacles = {}},
          .stations = {station()},
          .plan = plan(),
          .claim_lease = Duration{3'000'000'000},
          .whole = true};
}

double to_way_m(FieldPoint p, FieldPoint a, FieldPoint b) {
  const double dx = (b - a).x.base(), dy = (b - a).y.base();
  const double px = (p - a).x.base(), py = (p - a).y.base();
  const double t = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(px - t * dx, py - t * dy);
}

TEST_CASE("strips: a plan on strips of any direction is flown whole and within the laws", "[sim]") {
  const Log log = flown(plan());
  REQUIRE(log.finished);
  check_laws(facts(), log);
  const auto cells = static_cast<std::uint32_t>(route().centers.size());
  std::vector<int> passed(cells);
  std::vector<SortieReport> sorties;
  SchedulerState last{};
  for (const Envelope& e : log.envelopes) {
    if (const auto* record = std::get_if<FlightRecord>(&e.body)) {
      for (std::uint32_t c = record->cells.first; c < end(record->cells); ++c) ++passed[c];
    }
    if (const auto* report = std::get_if<SortieReport>(&e.body)) sorties.push_back(*report);
    if (const auto* state = std::get_if<SchedulerState>(&e.body)) last = *state;
  }
  CHECK(std::count(passed.begin(), passed.end(), 1) == cells);
  CHECK(last.completed);
  CHECK(last.sprayed_cells == cells);

  REQUIRE(sorties.size() == 3);
  // Cells of strip 1 are 2 m: the far edge of the twelfth is 24 m up, and work goes on there.
  CHECK(distance(sorties[0].returned_at, at_m(10, 34)).base() < 1e-9);
  CHECK(distance(sorties[1].resumed_at, at_m(10, 34)).base() < 1e-9);
  CHECK(distance(sorties[1].returned_at, at_m(80, 10)).base() < 1e-9);
  CHECK(distance(sorties[2].resumed_at, at_m(70, 5)).base() < 1e-9);  // not by the connection
  // Corners at an open valve are cut: from a straight way out of up to 1 m before the corner at
  // most, so by less than that at each end.
  const double spray_m[] = {24.0, 26.0 + 50.0, 41.3};
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(sorties[k].sprayed.base() == Approx(spray_m[k]).margin(2.0 * swath_m / 2));
  }
}

TEST_CASE("strips: a narrowed strip is sprayed as wide as it is planned, others whole", "[sim]") {
  int narrow = 0, whole = 0;
  for (const Envelope& e : flown(plan()).envelopes) {
    const auto* record = std::get_if<FlightRecord>(&e.body);
    if (record == nullptr) continue;
    for (const TrackPoint& p : record->track) {
      if (!p.spraying) {
        CHECK(p.width == Length{});
        continue;
      }
      const bool is_last = p.position.y < metres(6) && p.position.x < metres(72);
      CHECK(p.width.base() == (is_last ? 1.2 : 0.0));
      ++(is_last ? narrow : whole);
    }
  }
  CHECK(narrow > 10);  // 41.3 m at 3 m/s, one point a second
  CHECK(whole > 30);   // 100 m
}

TEST_CASE("strips: connections are flown along their way points, corners cut by half a swath",
          "[sim]") {
  std::vector<TrackPoint> track;
  for (const Envelope& e : flown(plan()).envelopes) {
    const auto* record = std::get_if<FlightRecord>(&e.body);
    if (record) track.insert(track.end(), record->track.begin(), record->track.end());
  }
  // From the end of strip 1 in the second sortie to the beginning of strip 2 the valve is closed.
  const auto near_end = [](const TrackPoint& p) {
    return p.spraying && p.position.y.base() > 55.0;
  };
  const auto last_open = std::find_if(track.begin(), track.end(), near_end);
  REQUIRE(last_open != track.end());
  const auto closed =
      std::find_if(last_open, track.end(), [](const auto& p) { return !p.spraying; });
  const auto opened = std::find_if(closed, track.end(), [](const auto& p) { return p.spraying; });
  REQUIRE(opened - closed > 5);
  for (auto p = closed; p != opened; ++p) {
    double off_m = 1e9;
    for (std::size_t i = 1; i < lane.size(); ++i) {
      off_m = std::min(off_m, to_way_m(p->position, lane[i - 1], lane[i]));
    }
    CHECK(off_m <= swath_m / 2);
  }
}

}  // namespace
}  // namespace furrow::sim
