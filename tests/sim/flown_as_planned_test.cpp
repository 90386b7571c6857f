// The plan's forecast against the flight: whole missions, planned and simulated in this process.

#include "mission/load.hpp"
#include "scheduler/plan_fleet.hpp"
#include "sim/checkers/laws.hpp"
#include "tests/sim/check_laws.hpp"
#include "tests/sim/whole_fleet.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace furrow::sim {
namespace {

/// When the last cell was sprayed, as the agents report their sorties.
double makespan_s(const Log& log) {
  double latest_s = 0.0;
  for (const Envelope& e : log.envelopes) {
    const auto* sortie = std::get_if<SortieReport>(&e.body);
    if (sortie == nullptr) continue;
    latest_s = std::max(latest_s, seconds(sortie->spray_ended.time_since_epoch()).base());
  }
  return latest_s;
}

template <class Plan>
Log flown_to_the_end(const mission::Scenario& scenario, const Plan& plan) {
  REQUIRE(plan);
  Log log = flown(scenario, *plan);
  REQUIRE(log.finished);
  return log;
}

/// Flown makespan by planned makespan.
double flown_to_planned(const mission::Scenario& scenario) {
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(scenario));
  const Log log = flown_to_the_end(scenario, plan);
  return makespan_s(log) / plan->makespan_s;
}

mission::Scenario scenario(const char* name) {
  auto loaded = mission::load(std::string{"scenarios/"} + name + ".yaml");
  REQUIRE(loaded);
  return *loaded;
}

TEST_CASE("flown as planned: three aircraft at one bay", "[sim]") {
  CHECK(flown_to_planned(scenario("wang2017_field_a")) == Approx(1.0).margin(0.01));
}

TEST_CASE("flown as planned: unlike aircraft at two stations", "[sim]") {
  mission::Scenario mixed = scenario("fleet_20");
  // Both types, each with its station's side of a smaller field.
  mixed.field = {.boundary = {at_m(200, 0), at_m(1050, 0), at_m(1050, 300), at_m(200, 300)},
                 .holes = {},
                 .obstacles = {}};
  mixed.start.reset();
  mixed.uavs.erase(mixed.uavs.begin() + 15, mixed.uavs.end());
  mixed.uavs.erase(mixed.uavs.begin() + 3, mixed.uavs.begin() + 12);
  CHECK(flown_to_planned(mixed) == Approx(1.0).margin(0.02));
}

Facts facts_of(const mission::Scenario& scenario, const scheduler::FleetPlan& plan) {
  return {.field = scenario.field,
          .stations = scenario.stations,
          .plan = plan,
          .claim_lease = scenario.agent_lease,
          .whole = true,
          .wind = scenario.wind,
          .surprises = scenario.surprises,
          .separation = scenario.separation};
}

void fly_around_surprises(const char* name, std::size_t trees) {
  const mission::Scenario scene = scenario(name);
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(scene));
  const Log log = flown_to_the_end(scene, plan);
  const Facts facts = facts_of(scene, *plan);
  check_laws(facts, log);
  SchedulerState last{};
  std::size_t sighted = 0;
  std::set<AgentId> told;
  for (const Envelope& e : log.envelopes) {
    if (const auto* state = std::get_if<SchedulerState>(&e.body)) last = *state;
    const auto* event = std::get_if<Event>(&e.body);
    sighted += event != nullptr && event->kind == "obstacle_seen";
    CHECK_FALSE((event != nullptr && event->kind == "obstacle_near"));
    const auto* command = std::get_if<Command>(&e.body);
    if (command && !command->obstacles.empty()) told.insert(command->agent);
  }
  CHECK(last.completed);
  CHECK(sighted == trees);
  CHECK(told.size() == 2);
  // Detours, and waiting until the ways home and out are clear of each other.
  CHECK(makespan_s(log) / plan->makespan_s == Approx(1.0).margin(0.14));
}

TEST_CASE("flown as planned: around a tree that no map shows, by all laws and every cell once",
          "[sim]") {
  fly_around_surprises("surprise_tree", 1);
}

TEST_CASE("flown as planned: around trees among cells, by all laws and every cell once", "[sim]") {
  fly_around_surprises("orchard_grid", 1);
}

TEST_CASE("flown as planned: around trees on a hill, by all laws and every cell once", "[sim]") {
  fly_around_surprises("surprise_hill", 2);
}

TEST_CASE(
    "flown as planned: trees in a file are flown around to the last, though the way is as long",
    "[sim]") {
  // 1 m beside the middle line of the cells at 69 m, which is led past them at a distance: past the
  // third as past the second the way is as long.
  const auto read = mission::parse(R"(
version: 1
name: file
field:
  boundary_m: [[0, 0], [120, 0], [120, 204], [0, 204]]
  work_direction_deg: 0
  coverage: {model: grid, avoidance: {method: genetic, safety_m: 1.5}}
obstacles:
  - {id: a, center_m: [68, 100], radius_m: 1, seen_within_m: 25}
  - {id: b, center_m: [68, 105], radius_m: 1, seen_within_m: 25}
  - {id: c, center_m: [68, 110], radius_m: 1, seen_within_m: 25}
supply:
  - {id: 1, position_m: [60, -10], bays: 2, battery_swap_s: 60, fill: {base_s: 20, full_s: 60}}
uavs:
  - {count: 2, swath_m: 6, spray_speed_mps: 4, ferry_speed_mps: 8, spray_endurance_s: 600,
     flight_endurance_s: 1100}
)",
                                   "file.yaml");
  REQUIRE(read);
  const mission::Scenario& scene = *read;
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(scene));
  const Log log = flown_to_the_end(scene, plan);
  check_laws(facts_of(scene, *plan), log);
}

TEST_CASE("flown as planned: nobody is lost who stops short of a wall of trees, one by one",
          "[sim]") {
  mission::Scenario scene = scenario("surprise_tree");
  scene.surprises.clear();
  // Right across the field: 6 m apart, and 3.1 m to keep clear of.
  for (int i = 0; i < 20; ++i) {
    scene.surprises.push_back({.id = "tree " + std::to_string(i),
                               .obstacle = {at_m(3 + 6 * i, 100), metres(1.5)},
                               .appears = {},
                               .seen_within = metres(25)});
  }
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(scene));
  const Log log = flown_to_the_end(scene, plan);
  check_laws(facts_of(scene, *plan), log);
  std::map<NodeId, int> stops;
  SchedulerState last{};
  for (const Envelope& e : log.envelopes) {
    if (const auto* state = std::get_if<SchedulerState>(&e.body)) last = *state;
    const auto* event = std::get_if<Event>(&e.body);
    if (event != nullptr && event->kind == "obstacle_near") ++stops[e.from];
  }
  CHECK(last.lost.empty());
  CHECK(stops[node(AgentId{1})] > 3);  // as often as would make an aircraft that strays unfit
}

TEST_CASE("flown as planned: a survey over hills around a mast that no map shows", "[sim]") {
  mission::Scenario scene = scenario("survey_valley");
  std::visit([](auto& settings) { settings.avoidance.emplace().safety = metres(2); },
             scene.coverage);
  // In the middle of the longest leg between two way points.
  const auto bare = scheduler::plan_fleet(mission::fleet_problem(scene));
  REQUIRE(bare);
  std::vector<FieldPoint> longest{at_m(0, 0), at_m(0, 0)};
  const CellRange strips = bare->uavs.front().strips;
  for (std::size_t i = strips.first + 1; i < end(strips); ++i) {
    std::vector<FieldPoint> way{bare->route.strips[i - 1].end};
    const planner::Strip& next = bare->route.strips[i];
    way.insert(way.end(), next.approach.begin(), next.approach.end());
    way.push_back(next.begin);
    for (std::size_t k = 1; k < way.size(); ++k) {
      const bool is_longer = distance(way[k - 1], way[k]) > distance(longest[0], longest[1]);
      if (is_longer) longest = {way[k - 1], way[k]};
    }
  }
  const FieldPoint mast = at_m(0.5 * (longest[0].x.base() + longest[1].x.base()),
                               0.5 * (longest[0].y.base() + longest[1].y.base()));
  scene.surprises.push_back(
      {.id = "mast", .obstacle = {mast, metres(1)}, .appears = {}, .seen_within = metres(60)});
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(scene));
  REQUIRE(plan);
  CHECK(plan->makespan_s == Approx(bare->makespan_s));
  const Log log = flown(scene, *plan);
  REQUIRE(log.finished);
  check_laws(facts_of(scene, *plan), log);
  SchedulerState last{};
  std::size_t sighted = 0;
  double nearest_m = 1e9;
  for (const Envelope& e : log.envelopes) {
    if (const auto* state = std::get_if<SchedulerState>(&e.body)) last = *state;
    const auto* event = std::get_if<Event>(&e.body);
    sighted += event != nullptr && event->kind == "obstacle_seen";
    const auto* flown = std::get_if<FlightRecord>(&e.body);
    for (const TrackPoint& p : flown != nullptr ? flown->track : std::vector<TrackPoint>{}) {
      nearest_m = std::min(nearest_m, distance(p.position, mast).base());
    }
  }
  CHECK(last.completed);
  CHECK(sighted >= 1);
  // It passes, as near as radius and safety distance allow but for what the fix is off by.
  CHECK(nearest_m > 1 + 0.9 * 2);
  CHECK(nearest_m < 10);
}

TEST_CASE("flown as planned: behind a tree that leaves no way the strips are flown from elsewhere",
          "[sim]") {
  // An alley of 12 m, and 6.1 m around the centre to keep clear of. Rows of 6 m overlap by 0.06 m,
  // so it takes three.
  const mission::Scenario alley = scenario("alley_blocked");
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(alley));
  const Log log = flown_to_the_end(alley, plan);
  const Facts facts = facts_of(alley, *plan);
  check_laws(facts, log);
  SchedulerState last{};
  std::size_t blocked = 0;
  for (const Envelope& e : log.envelopes) {
    if (const auto* state = std::get_if<SchedulerState>(&e.body)) last = *state;
    const auto* event = std::get_if<Event>(&e.body);
    blocked += event != nullptr && event->kind == "way_blocked";
  }
  CHECK_FALSE(last.completed);
  CHECK(plan->route.strips.size() == 3);
  CHECK(blocked == 3);
  // Of each row of 200 m at most 2 6.1 m lie within the circle, and half a metre and a cell before
  // and behind: cells of 6 m.
  CHECK(last.abandoned_cells * plan->route.cell.base() < 3 * (12.2 + 0.5 + 2 * 6));
  CHECK(last.abandoned_cells > 0);
}

/// Packs, as used in flight by planned.
double used_to_planned(const scheduler::FleetPlan& plan, const Log& log) {
  double planned = 0, used = 0;
  for (const auto& uav : plan.uavs) {
    for (const auto& sortie : uav.solution.plan.sorties) planned += sortie.battery_used;
  }
  for (const Envelope& e : log.envelopes) {
    if (const auto* sortie = std::get_if<SortieReport>(&e.body)) used += sortie->battery_used;
  }
  return used / planned;
}

TEST_CASE("flown as planned: over terraces of an elevation raster, in time and of the packs",
          "[sim]") {
  const mission::Scenario terraces = scenario("terraced");
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(terraces));
  const Log log = flown_to_the_end(terraces, plan);
  CHECK(makespan_s(log) / plan->makespan_s == Approx(1.0).margin(0.02));
  CHECK(used_to_planned(*plan, log) == Approx(1.0).margin(0.02));
  check_laws(facts_of(terraces, *plan), log);
}

TEST_CASE("flown as planned: over hills, in time and of the packs, at heights that are kept",
          "[sim]") {
  const mission::Scenario hills = scenario("hills");
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(hills));
  const Log log = flown_to_the_end(hills, plan);
  CHECK(makespan_s(log) / plan->makespan_s == Approx(1.0).margin(0.02));
  CHECK(used_to_planned(*plan, log) == Approx(1.0).margin(0.01));
  const Facts facts = facts_of(hills, *plan);
  check_laws(facts, log);

  // The same flight, had every height been 2 m less, or on ferries of the higher layer 4 m less,
  // though still above the clearance.
  const auto is_told = [&](auto lower) {
    auto changed = log.envelopes;
    for (Envelope& e : changed) {
      auto* record = std::get_if<FlightRecord>(&e.body);
      if (record == nullptr) continue;
      for (TrackPoint& p : record->track) lower(record->agent, p);
    }
    const auto broken = violations(facts, changed, log.ended);
    return std::any_of(broken.begin(), broken.end(),
                       [](const Violation& v) { return v.law == "L23"; });
  };
  const planner::Relief& relief = *plan->route.ferries.relief();
  CHECK(is_told([](AgentId, TrackPoint& p) { p.altitude_m -= 2; }));
  CHECK(is_told([&](AgentId agent, TrackPoint& p) {
    const double least_m = (relief.surface().height(p.position) + metres(12)).base();
    if (agent == AgentId{2} && p.altitude_m > least_m) {
      p.altitude_m = std::max(least_m, p.altitude_m - 4);
    }
  }));
}

TEST_CASE("flown as planned: below a ceiling past a ridge that is higher", "[sim]") {
  mission::Scenario ridge = scenario("ridge");
  ridge.terrain->rule.ceiling = metres(45);  // the crest is at 55 m
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(ridge));
  const Log log = flown_to_the_end(ridge, plan);
  CHECK(makespan_s(log) / plan->makespan_s == Approx(1.0).margin(0.02));
  CHECK(used_to_planned(*plan, log) == Approx(1.0).margin(0.02));
  const Facts facts = facts_of(ridge, *plan);
  check_laws(facts, log);

  ridge.terrain->ferries.reset();
  CHECK_FALSE(scheduler::plan_fleet(mission::fleet_problem(ridge)));
  Facts lower = facts;  // the same flight under a ceiling of 30 m
  ridge.terrain->rule.ceiling = metres(30);
  const Extent extent{at_m(-100, -250), at_m(500, 200)};
  lower.plan.route.ferries =
      lower.plan.route.ferries.over_ground(planner::Relief{*ridge.terrain, extent});
  const auto broken = violations(lower, log.envelopes, log.ended);
  REQUIRE(!broken.empty());
  CHECK(broken.front().law == "L23");
}

// Least distance of a flown track from `p`, in plan.
double passed_within_m(const Log& log, FieldPoint p) {
  Length least = metres(1e9);
  for (const Envelope& e : log.envelopes) {
    const auto* record = std::get_if<FlightRecord>(&e.body);
    if (record == nullptr) continue;
    for (std::size_t i = 1; i < record->track.size(); ++i) {
      const FieldPoint a = record->track[i - 1].position, b = record->track[i].position;
      const FieldVector way = b - a, off = p - a;
      const double squares = (way.x * way.x + way.y * way.y).base();
      const double along = squares > 0 ? (way.x * off.x + way.y * off.y).base() / squares : 0;
      const double t = std::clamp(along, 0.0, 1.0);
      least = std::min(least, distance(p, a + FieldVector{t * way.x, t * way.y}));
    }
  }
  return least.base();
}

TEST_CASE("flown as planned: a survey visits its way points over hills and sprays nothing",
          "[sim]") {
  const mission::Scenario valley = scenario("survey_valley");
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(valley));
  const Log log = flown_to_the_end(valley, plan);
  CHECK(makespan_s(log) / plan->makespan_s == Approx(1.0).margin(0.02));
  CHECK(used_to_planned(*plan, log) == Approx(1.0).margin(0.02));
  std::size_t visits = 0;
  for (const Envelope& e : log.envelopes) {
    if (const auto* sortie = std::get_if<SortieReport>(&e.body)) {
      CHECK(sortie->sprayed == Length{});
    }
    if (const auto* record = std::get_if<FlightRecord>(&e.body)) {
      visits += record->cells.count;
      for (const TrackPoint& p : record->track) CHECK_FALSE(p.spraying);
    }
  }
  CHECK(visits == valley.survey->way_points.size());
  // Corners are cut by half a swath, 2 m, at most.
  for (const FieldPoint p : valley.survey->way_points) CHECK(passed_within_m(log, p) < 2.1);
  check_laws(facts_of(valley, *plan), log);

  // The same flights, had one aircraft been at the axis of the keep-out volume once.
  auto entered = log.envelopes;
  const auto first = std::find_if(entered.begin(), entered.end(), [](const Envelope& e) {
    return std::holds_alternative<FlightRecord>(e.body);
  });
  REQUIRE(first != entered.end());
  std::get<FlightRecord>(first->body).track.front().position = at_m(760, 430);
  const auto told = violations(facts_of(valley, *plan), entered, log.ended);
  CHECK(std::any_of(told.begin(), told.end(), [](const Violation& v) { return v.law == "L25"; }));
}

}  // namespace
}  // namespace furrow::sim
