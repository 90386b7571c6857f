// An aircraft and obstacles that no plan knew.

#include "agents/agent_node.hpp"
#include "agents/vehicle/lookout.hpp"
#include "tests/agents/scripted_fleet.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <utility>

namespace furrow::agents {
namespace {

Surprise tree(double x_m, double y_m, double seen_m) {
  return {.id = "tree",
          .obstacle = {at_m(x_m, y_m), metres(1)},
          .appears = {},
          .seen_within = metres(seen_m)};
}

// Land from x = -20 to `east_m`; 2 m from trees.
AgentSettings with(const Surprise& surprise, double east_m = 40) {
  AgentSettings settings = settings_of(sprayer());
  const planner::LandParts land{{{{-20, -20}, {east_m, -20}, {east_m, 220}, {-20, 220}}, {}}};
  settings.avoidance = {
      .planned = {{}, {}, land}, .clearance = metres(2), .turn_radius = metres(2)};
  settings.surprises = {surprise};
  return settings;
}

// Two strips of 100 cells, at x = 1 and x = 3.
ScriptedScheduler two_strips() { return {.sorties = {{strips(2, 100), StationId{1}}}}; }

double nearest_m(const std::vector<Envelope>& log, FieldPoint place) {
  double least = 1e9;
  for (const FlightRecord& record : all<FlightRecord>(log)) {
    for (const TrackPoint& p : record.track) {
      least = std::min(least, distance(p.position, place).base());
    }
  }
  return least;
}

std::size_t count(const std::vector<Envelope>& log, std::string_view kind) {
  const auto events = all<Event>(log);
  return static_cast<std::size_t>(
      std::count_if(events.begin(), events.end(), [&](const Event& e) { return e.kind == kind; }));
}

std::uint32_t cells_sprayed(const std::vector<Envelope>& log) {
  std::uint32_t sum = 0;
  for (const FlightRecord& record : all<FlightRecord>(log)) sum += record.cells.count;
  return sum;
}

TEST_CASE("lookout: an obstacle is seen once, from its edge, and not before it appears",
          "[agents]") {
  Surprise late = tree(0, 50, 10);
  late.appears = mission_start + 5 * second;
  Lookout lookout{{tree(0, 50, 10), late}};
  CHECK(lookout.sees({0, 38.9}, mission_start).empty());
  CHECK(lookout.sees({0, 39.1}, mission_start).size() == 1);
  CHECK(lookout.sees({0, 39.1}, mission_start).empty());
  CHECK(lookout.sees({0, 39.1}, mission_start + 5 * second).size() == 1);
}

TEST_CASE("agent: flies around a tree that it sees, every cell once", "[agents]") {
  const auto log = fly(with(tree(1.5, 100, 20)), two_strips(), mission_start + 600 * second);
  CHECK(count(log, "obstacle_seen") == 1);
  CHECK(count(log, "obstacle_near") == 0);
  // It stands between both strips, 0.5 and 1.5 m from them, and they keep 3 m.
  CHECK(count(log, "detour_sprayed") + count(log, "detour_closed") == 2);
  CHECK(count(log, "order_done") == 1);
  CHECK(cells_sprayed(log) == 200);
  // 1 m of tree and 2 m of clearance, less what a fix of 2 cm does to the track.
  CHECK(nearest_m(log, at_m(1.5, 100)) > 2.8);
  for (const Closure& c : all<WorkReport>(log).front().closures) {
    CHECK(c.reason == CloseReason::sprayed);
  }
}

TEST_CASE("agent: flies around it without a stop although its fixes are noisy", "[agents]") {
  AgentSettings noisy = with(tree(1.5, 100, 20));
  noisy.vehicle.gnss.sigma = metres(0.02);
  const auto log = fly(noisy, two_strips(), mission_start + 600 * second);
  CHECK(count(log, "obstacle_seen") == 1);
  CHECK(count(log, "obstacle_near") == 0);
  CHECK(cells_sprayed(log) == 200);
}

TEST_CASE("agent: says what it saw until an order names it", "[agents]") {
  // This scheduler never does: it is told with every heartbeat.
  const auto log = fly(with(tree(1.5, 100, 20)), two_strips(), mission_start + 120 * second);
  const auto told = all<ObstacleSeen>(log);
  CHECK(told.size() > 10);
  CHECK(told.front().obstacle == SeenObstacle{at_m(1.5, 100), metres(1)});
  CHECK(told.front().clearance == metres(2));
}

TEST_CASE("agent: stops before an obstacle that it sees too late for a way around", "[agents]") {
  // From 3 m/s it stops in 3 0.1 + 9 / (2 2.7) = 2 m; turn circles begin sqrt(5^2 - 2^2) = 4.6 m
  // before the centre, and it sees the tree at 5 m from its centre.
  const auto log = fly(with(tree(1.5, 100, 4)), two_strips(), mission_start + 600 * second);
  CHECK(count(log, "obstacle_near") == 1);
  CHECK(nearest_m(log, at_m(1.5, 100)) > 2.5);
}

TEST_CASE("agent: holds before an obstacle that leaves no way, and gives its windows back",
          "[agents]") {
  AgentSettings alley = with(tree(1, 100, 20));
  alley.avoidance.planned =
      planner::Room{{}, {}, {{{{-1.5, -20}, {3.5, -20}, {3.5, 220}, {-1.5, 220}}, {}}}};
  auto scheduler = two_strips();
  bool was_granted = false;
  scheduler.may_grant = [was_granted](CellRange cells, Instant) mutable {
    if (cells.first != 0) return false;
    return !std::exchange(was_granted, true);
  };
  const auto log = fly(alley, scheduler, mission_start + 80 * second);
  CHECK(count(log, "way_blocked") == 1);
  const auto reports = all<WorkReport>(log);
  REQUIRE_FALSE(reports.empty());
  const Closure& closure = reports.front().closures.front();
  CHECK(closure.reason == CloseReason::blocked);
  // It holds half a metre before y = 97, so at 96.5; the centre of cell 47 lies at 95.
  CHECK(closure.sprayed == 48);
  CHECK(nearest_m(log, at_m(1, 100)) > 2.8);
  CHECK(all<AgentState>(log).back().phase == Phase::hold);
}

}  // namespace
}  // namespace furrow::agents
