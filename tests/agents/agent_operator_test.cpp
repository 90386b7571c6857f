#include "agents/agent_node.hpp"
#include "tests/agents/scripted_fleet.hpp"

#include <catch2/catch.hpp>

namespace furrow::agents {
namespace {

OperatorState level(std::uint32_t revision, FleetLevel level, std::vector<AgentId> out = {}) {
  return {.epoch = Epoch{1}, .revision = revision, .level = level, .taken_out = std::move(out)};
}

// Three strips of 100 cells of 2 m in two sorties, all granted from the second second on. At 3 m/s
// cell 57 is passed about 40 s after take-off, and the first sortie's last, 149, after 100 s.
std::map<int, std::vector<Body>> at_work() {
  const Command command{agent_7, boot_1, Epoch{1}, 1, two_sorties(strips(3, 100), 149)};
  const WorkGrant all_four{
      agent_7, boot_1, Epoch{1},
      1,       0,      {{1, {0, 100}}, {2, {100, 50}}, {3, {150, 50}}, {4, {200, 100}}}};
  return {{1, {command}}, {2, {all_four}}};
}

struct Said {
  std::vector<Envelope> log;

  // Cells passed with the valve open, from `from_s` until before `to_s`.
  std::size_t cells(int from_s, int to_s) const {
    std::size_t count = 0;
    for (const Envelope& e : log) {
      const auto* record = std::get_if<FlightRecord>(&e.body);
      const bool is_then =
          e.sent >= mission_start + from_s * second && e.sent < mission_start + to_s * second;
      if (record != nullptr && is_then) count += record->cells.count;
    }
    return count;
  }
  Phase phase_at(int s) const {
    for (const Envelope& e : log) {
      const auto* state = std::get_if<AgentState>(&e.body);
      if (state != nullptr && e.sent == mission_start + s * second) return state->phase;
    }
    FAIL("no heartbeat at " << s << " s");
    return {};
  }
};

Said told(std::map<int, std::vector<Body>> orders, int to_s = 600) {
  AgentNode agent{settings_of(sprayer())};
  for (auto& [at, bodies] : at_work()) {
    auto& all = orders[at];
    all.insert(all.begin(), bodies.begin(), bodies.end());
  }
  return {told_by_second(agent, orders, to_s)};
}

TEST_CASE("operator: a paused aircraft hovers with its valve closed and goes on where it stopped",
          "[agents]") {
  const Said said = told({{40, {level(1, FleetLevel::hold)}}, {90, {level(2, FleetLevel::fly)}}});
  CHECK(said.phase_at(43) == Phase::hold);  // 3 m/s are braked within a second and two cells
  CHECK(said.phase_at(89) == Phase::hold);
  CHECK(said.cells(43, 90) == 0);
  CHECK(each_once(said.log, 300));
  for (const auto& report : all<WorkReport>(said.log)) {
    for (const Closure& c : report.closures) CHECK(c.reason == CloseReason::sprayed);
  }
  CHECK(all<SortieReport>(said.log).size() == 2);
  CHECK(said.phase_at(599) == Phase::done);
}

TEST_CASE("operator: who is paused on its way home lands, and does not take off", "[agents]") {
  const Said said = told({{104, {level(1, FleetLevel::hold)}}, {300, {level(2, FleetLevel::fly)}}});
  CHECK(said.phase_at(104) == Phase::fly_back);
  CHECK(said.phase_at(299) == Phase::wait);
  CHECK(said.cells(110, 300) == 0);
  CHECK(each_once(said.log, 300));
  CHECK(said.phase_at(599) == Phase::done);
}

TEST_CASE("operator: an aircraft called home lands there with its work kept, and resumes it",
          "[agents]") {
  const Said said = told({{40, {level(1, FleetLevel::land)}}}, 300);
  CHECK(said.phase_at(41) == Phase::spray);  // to the next cell at which it can stop
  CHECK(said.phase_at(299) == Phase::wait);
  const auto reports = all<WorkReport>(said.log);
  REQUIRE_FALSE(reports.empty());
  REQUIRE(reports.back().closures.size() == 4);
  const Closure& cut = reports.back().closures.front();
  CHECK(cut.reason == CloseReason::recalled);
  CHECK(cut.sprayed == passes(said.log).size());

  // The rest is granted again, and flown from the very next cell on.
  const std::uint32_t next = cut.sprayed;
  const WorkGrant rest{
      agent_7, boot_1, Epoch{1},
      1,       4,      {{5, {next, 100 - next}}, {6, {100, 50}}, {7, {150, 50}}, {8, {200, 100}}}};
  const Said again =
      told({{40, {level(1, FleetLevel::land)}}, {80, {rest}}, {120, {level(2, FleetLevel::fly)}}});
  CHECK(again.phase_at(119) == Phase::wait);
  CHECK(each_once(again.log, 300));
  CHECK(again.phase_at(599) == Phase::done);
}

TEST_CASE("operator: a call home that is taken back at once costs nothing but its braking",
          "[agents]") {
  const Said said = told({{40, {level(1, FleetLevel::land), level(2, FleetLevel::fly)}}});
  CHECK(each_once(said.log, 300));
  CHECK(all<SortieReport>(said.log).size() == 2);
}

TEST_CASE("operator: one that is taken out gives its windows back at home and stays there",
          "[agents]") {
  // In the air at work, on the way home, and before it has taken off.
  for (const int at_s : {40, 104, 1}) {
    CAPTURE(at_s);
    const Said said = told({{at_s, {level(1, FleetLevel::fly, {agent_7})}}}, 300);
    CHECK(said.phase_at(299) == Phase::offline);
    CHECK(said.cells(110, 300) == 0);
    CHECK(contains(event_kinds(said.log), "dismissed"));
    const auto acks = all<CommandAck>(said.log);
    if (!acks.empty()) CHECK(acks.back().status != AckStatus::failed);
    if (at_s == 1) continue;  // refuses nothing: it has no order yet, or never flies it
    REQUIRE_FALSE(all<WorkReport>(said.log).empty());
    CHECK(all<WorkReport>(said.log).back().closures.back().reason == CloseReason::recalled);
  }
  const Said other = told({{40, {level(1, FleetLevel::fly, {AgentId{8}})}}});
  CHECK(each_once(other.log, 300));
}

TEST_CASE("operator: one that hears that it was taken for lost comes home for good", "[agents]") {
  SchedulerState lost{}, others{};
  lost.epoch = others.epoch = Epoch{1};
  lost.phase = others.phase = MissionPhase::flying;
  lost.lost = {agent_7};
  others.lost = {AgentId{8}};
  const Said said = told(
      {{40, {lost}}, {60, {level(1, FleetLevel::land)}}, {80, {level(2, FleetLevel::fly)}}}, 300);
  CHECK(contains(event_kinds(said.log), "given_up"));
  CHECK(said.phase_at(50) == Phase::fly_back);
  CHECK(said.phase_at(299) == Phase::offline);
  CHECK(all<SortieReport>(said.log).size() == 1);
  const Said other = told({{40, {others}}});
  CHECK(each_once(other.log, 300));
}

TEST_CASE("operator: a stopped mission ends on the ground, also for who waits for a bay",
          "[agents]") {
  const Vehicle small = [] {
    Vehicle v = sprayer();
    v.spray_endurance = seconds(110);  // 330 m: filled after the first sortie
    return v;
  }();
  AgentNode agent{settings_of(small)};
  auto orders = at_work();
  orders[150].push_back(level(1, FleetLevel::end));
  const Said said{told_by_second(agent, orders, 300)};
  CHECK(said.phase_at(149) == Phase::wait);
  CHECK(said.phase_at(151) == Phase::offline);
  REQUIRE_FALSE(all<ServiceClaim>(said.log).empty());
  CHECK(all<ServiceClaim>(said.log).back().status == ClaimStatus::released);
}

TEST_CASE("operator: an older level that arrives late changes nothing", "[agents]") {
  const Said said = told({{40, {level(2, FleetLevel::fly)}}, {41, {level(1, FleetLevel::hold)}}});
  CHECK(said.phase_at(50) == Phase::spray);
  CHECK(each_once(said.log, 300));
}

}  // namespace
}  // namespace furrow::agents
