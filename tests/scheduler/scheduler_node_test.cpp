#include "scheduler/scheduler_node.hpp"

#include "core/node_host.hpp"
#include "tests/scheduler/six_strips.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <string>
#include <utility>

namespace furrow::scheduler {
namespace {

using std::chrono::seconds;

constexpr Link quiet_radio{
    .latency = Duration{20'000'000}, .jitter = {}, .loss = 0, .duplication = 0};
constexpr Link bad_radio{.latency = Duration{20'000'000},
                         .jitter = Duration{300'000'000},
                         .loss = 0.2,
                         .duplication = 0.2};

// Follows its order as an aircraft would: one window after the other, two cells a second, every
// third window closed before its end. Says where it stands once a second.
struct Follower {
  AgentId id;
  std::map<std::uint32_t, int>* sprayed;
  std::uint32_t ordered = 0;
  std::uint32_t revision = 0;
  std::uint32_t done = 0;
  std::uint64_t last_accepted = 0, last_closed = 0;
  std::map<std::uint64_t, CellRange> open{};
  std::vector<Closure> unbooked{};
  bool is_known = false;

  void hear(const Command& c) {
    revision = c.revision;
    ordered = 0;
    for (const auto& sortie : c.sorties) {
      for (const auto& piece : sortie.pieces) ordered += piece.cells.count;
    }
  }

  void hear(const WorkGrant& g) {
    std::erase_if(unbooked, [&](const Closure& c) { return c.grant <= g.closed_through; });
    for (const GrantWindow& w : g.windows) {
      if (w.id <= last_accepted) continue;
      open.emplace(w.id, w.cells);
      last_accepted = w.id;
    }
  }

  void work(Instant now) {
    if (open.empty()) return;
    auto next = open.begin();
    for (auto it = open.begin(); it != open.end(); ++it) {
      if (it->second.first < next->second.first) next = it;
    }
    const auto [grant, cells] = *next;
    const bool early = grant % 3 == 0 && cells.count > 1;
    const std::uint32_t count = early ? cells.count / 2 : cells.count;
    for (std::uint32_t c = cells.first; c < cells.first + count; ++c) ++(*sprayed)[c];
    done += count;
    unbooked.push_back(
        {grant, cells, count, early ? CloseReason::tank_low : CloseReason::sprayed, now});
    last_closed = std::max(last_closed, grant);
    open.erase(next);
  }

  AgentState state() const {
    AgentState s{};
    s.agent = id;
    s.boot = BootId{number(id)};
    s.epoch = Epoch{revision > 0 ? 1u : 0u};
    s.revision = revision;
    s.phase = revision == 0 ? Phase::idle : done == ordered ? Phase::done : Phase::spray;
    s.last_grant = last_accepted;
    s.last_closed = last_closed;
    return s;
  }

  Outbox step(const Inbox& inbox, Instant now) {
    const bool is_first = !std::exchange(is_known, true);
    for (const Envelope& e : inbox) {
      if (const auto* c = std::get_if<Command>(&e.body)) hear(*c);
      if (const auto* g = std::get_if<WorkGrant>(&e.body)) hear(*g);
    }
    Outbox out;
    out.wake = Instant{(now.time_since_epoch() / seconds{1} + 1) * seconds{1}};
    if (is_first) out.messages.push_back(AgentInfo{id, BootId{number(id)}, vehicle(number(id))});
    if (now.time_since_epoch() % seconds{1} != Duration::zero()) return out;
    work(now);
    out.messages.push_back(state());
    if (!unbooked.empty()) {
      out.messages.push_back(WorkReport{id, BootId{number(id)}, Epoch{1}, unbooked});
    }
    return out;
  }
};

struct Run {
  std::map<std::uint32_t, int> sprayed;
  std::vector<Envelope> log;

  std::vector<SchedulerState> states() const {
    std::vector<SchedulerState> found;
    for (const Envelope& e : log) {
      if (const auto* s = std::get_if<SchedulerState>(&e.body)) found.push_back(*s);
    }
    return found;
  }
  std::vector<std::pair<Instant, Event>> events(std::string_view kind) const {
    std::vector<std::pair<Instant, Event>> found;
    for (const Envelope& e : log) {
      const auto* event = std::get_if<Event>(&e.body);
      if (event != nullptr && event->kind == kind) found.emplace_back(e.sent, *event);
    }
    return found;
  }
};

// Flies until the mission is over; takes `victim` out at `killed_at`. The last agent is there from
// `joined_at` on.
Run fly(SchedulerSettings s, const Link& radio, std::uint64_t seed, std::uint32_t agents,
        Instant killed_at = never, AgentId victim = AgentId{0}, Instant joined_at = Instant{}) {
  Run run;
  NodeHost host{radio, seed};
  host.add(scheduler_node(), AnyNode{SchedulerNode{std::move(s)}}, Instant{});
  for (std::uint32_t i = 1; i <= agents; ++i) {
    host.add(node(AgentId{i}), AnyNode{Follower{AgentId{i}, &run.sprayed}},
             i == agents ? joined_at : Instant{}, AgentId{i} == victim ? killed_at : never);
  }
  while (host.next_event() < at_s(1200)) {
    for (Envelope& e : host.advance(host.next_event() + radio.latency)) {
      host.deliver(e);
      run.log.push_back(std::move(e));
    }
    const auto* state =
        run.log.empty() ? nullptr : std::get_if<SchedulerState>(&run.log.back().body);
    if (state != nullptr && state->phase == MissionPhase::finished) break;
  }
  return run;
}

TEST_CASE("scheduler_node: every cell is sprayed once and the mission completes", "[scheduler]") {
  const Run run = fly(settings(seconds{3}), quiet_radio, 1, 3);
  REQUIRE(run.sprayed.size() == strips * cells_per_strip);
  for (const auto& [cell, times] : run.sprayed) CHECK(times == 1);
  const SchedulerState last = run.states().back();
  CHECK(last.phase == MissionPhase::finished);
  CHECK(last.completed);
  CHECK(last.sprayed_cells == strips * cells_per_strip);
  CHECK(run.events("agent_lost").empty());
  CHECK(run.events("closure_refused").empty());
}

TEST_CASE("scheduler_node: over a lossy radio every cell is still sprayed once", "[scheduler]") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    // 20 s of silence by chance: 0.2^20 a second.
    const Run run = fly(settings(seconds{20}), bad_radio, seed, 3);
    REQUIRE(run.sprayed.size() == strips * cells_per_strip);
    for (const auto& [cell, times] : run.sprayed) REQUIRE(times == 1);
    REQUIRE(run.states().back().completed);
    REQUIRE(run.events("closure_refused").empty());
  }
}

TEST_CASE("scheduler_node: windows stay within a piece, two ahead, with ids that rise by one",
          "[scheduler]") {
  const Run run = fly(settings(seconds{3}), quiet_radio, 1, 3);
  std::map<AgentId, std::uint64_t> last;
  for (const Envelope& e : run.log) {
    const auto* grant = std::get_if<WorkGrant>(&e.body);
    if (grant == nullptr) continue;
    CHECK(grant->windows.size() <= 2);
    for (const GrantWindow& w : grant->windows) {
      CHECK(w.id <= last[grant->agent] + 1);
      last[grant->agent] = std::max(last[grant->agent], w.id);
      CHECK(w.cells.first / cells_per_strip == (end(w.cells) - 1) / cells_per_strip);
      CHECK((w.cells.first < 30) == (grant->agent == AgentId{1}));
    }
  }
  CHECK(last[AgentId{3}] == 0);
}

TEST_CASE(
    "scheduler_node: a killed agent is lost within its lease, its open windows are uncertain and "
    "the others take over the rest",
    "[scheduler]") {
  const Run run = fly(settings(seconds{3}), quiet_radio, 1, 3, at_s(3), AgentId{1});
  const auto lost = run.events("agent_lost");
  REQUIRE(lost.size() == 1);
  // Last heard of at 2.02 s, when what it said at 2 s arrived.
  CHECK(lost[0].first == at_s(5) + Duration{20'000'000});
  CHECK(run.events("cells_uncertain").size() == 2);
  CHECK(run.events("cells_abandoned").empty());
  CHECK_FALSE(run.events("work_taken_over").empty());

  const SchedulerState last = run.states().back();
  CHECK(last.phase == MissionPhase::finished);
  CHECK(last.completed);
  CHECK(last.lost == std::vector{AgentId{1}});
  CHECK(last.open_cells == 0);
  CHECK(last.sprayed_cells + last.abandoned_cells == strips * cells_per_strip);
  CHECK(last.abandoned_cells <= 20);  // two windows of a strip at most
  for (const auto& [cell, times] : run.sprayed) CHECK(times == 1);
}

TEST_CASE("scheduler_node: only those whose list grows are told, in a newer revision",
          "[scheduler]") {
  const Run run = fly(settings(seconds{3}), quiet_radio, 1, 3, at_s(3), AgentId{1});
  std::map<AgentId, std::uint32_t> revisions;
  for (const Envelope& e : run.log) {
    const auto* command = std::get_if<Command>(&e.body);
    if (command == nullptr) continue;
    CHECK(command->revision <= revisions[command->agent] + 1);
    revisions[command->agent] = command->revision;
  }
  CHECK(revisions[AgentId{1}] == 1);
  for (const std::uint32_t agent : {2u, 3u}) {
    const bool takes_over = revisions[AgentId{agent}] == 2;
    bool is_told = false;
    for (const auto& [at, taken] : run.events("work_taken_over")) {
      is_told |= taken.detail.starts_with("agent " + std::to_string(agent) + " ");
    }
    CHECK(is_told == takes_over);
  }
}

TEST_CASE("scheduler_node: who joins late is given what nobody has begun", "[scheduler]") {
  const Run run = fly(late_joiner(), quiet_radio, 1, 3, never, AgentId{0}, at_s(1));
  REQUIRE(run.events("agent_joined").size() == 1);
  CHECK(run.events("agent_joined")[0].first == at_s(1) + Duration{20'000'000});
  CHECK(run.events("agent_lost").empty());
  REQUIRE(run.events("work_taken_over").size() == 1);
  CHECK(run.events("work_taken_over")[0].second.detail ==
        "agent 3 takes over 20 cells in 1 sorties");
  const SchedulerState last = run.states().back();
  CHECK(last.completed);
  CHECK(last.sprayed_cells == strips * cells_per_strip);
  for (const auto& [cell, times] : run.sprayed) CHECK(times == 1);
  std::map<AgentId, std::size_t> sorties;
  for (const Envelope& e : run.log) {
    const auto* command = std::get_if<Command>(&e.body);
    if (command != nullptr) sorties[command->agent] = command->sorties.size();
  }
  CHECK(sorties ==
        std::map<AgentId, std::size_t>{{AgentId{1}, 2}, {AgentId{2}, 2}, {AgentId{3}, 1}});
}

TEST_CASE("scheduler_node: who joins when all is begun, or never, changes nothing", "[scheduler]") {
  for (const Instant joined_at : {at_s(3), never}) {
    const Run run = fly(late_joiner(), quiet_radio, 1, 3, never, AgentId{0}, joined_at);
    CHECK(run.events("work_taken_over").empty());
    CHECK(run.states().back().completed);
    for (const auto& [cell, times] : run.sprayed) CHECK(times == 1);
  }
}

TEST_CASE("scheduler_node: an obstacle is told to all once, with the same work", "[scheduler]") {
  SchedulerNode scheduler{settings(seconds{3})};
  std::uint64_t seq = 0;
  const auto tell = [&](std::uint32_t from, Instant now, Body body) {
    const NodeId sender = node(AgentId{from});
    return scheduler.step({{sender, ++seq, now, std::move(body)}}, now).messages;
  };
  std::map<AgentId, std::vector<Command>> told;
  const auto take = [&](const std::vector<Body>& said) {
    for (const Body& body : said) {
      if (const auto* c = std::get_if<Command>(&body)) told[c->agent].push_back(*c);
    }
  };
  for (const std::uint32_t i : {1u, 2u, 3u}) {
    take(tell(i, Instant{}, AgentInfo{AgentId{i}, BootId{i}, vehicle(i)}));
  }
  const ObstacleSeen seen{.agent = AgentId{1},
                          .boot = BootId{1},
                          .epoch = Epoch{1},
                          .revision = 1,
                          .obstacle = {at_m(1, 5), metres(1)},
                          .clearance = metres(2)};
  for (const int second : {1, 2}) take(tell(1, at_s(second), seen));
  for (const std::uint32_t i : {1u, 2u}) {
    const auto& commands = told[AgentId{i}];
    REQUIRE(commands.size() == 2);
    CHECK(commands[0].obstacles.empty());
    CHECK(commands[1].revision == 2);
    CHECK(commands[1].obstacles == std::vector{seen.obstacle});
    REQUIRE(commands[1].sorties.size() == commands[0].sorties.size());
    CHECK(commands[1].sorties[0].pieces == commands[0].sorties[0].pieces);
  }
}

TEST_CASE("scheduler_node: where nobody is left all is given up, with a reason", "[scheduler]") {
  SchedulerSettings s = settings(seconds{3});
  s.plan.uavs = {uav_plan(s.plan.route, 1, {0, 6}, {})};
  const Run run = fly(s, quiet_radio, 1, 1, at_s(3), AgentId{1});
  REQUIRE_FALSE(run.events("cells_abandoned").empty());
  CHECK(run.events("cells_abandoned")[0].second.detail.ends_with("no aircraft is left"));
  CHECK_FALSE(run.states().back().completed);
}

TEST_CASE("scheduler_node: an agent never heard of is lost after the gathering", "[scheduler]") {
  const Run run = fly(settings(seconds{3}), quiet_radio, 1, 1);
  const auto lost = run.events("agent_lost");
  REQUIRE(lost.size() == 2);
  CHECK(lost[0].first == at_s(10));
  const SchedulerState last = run.states().back();
  CHECK(last.completed);  // the one that is there sprays all
  CHECK(last.sprayed_cells == 60);
}

TEST_CASE("scheduler_node: one that comes back after it was lost is told nothing", "[scheduler]") {
  SchedulerNode scheduler{settings(seconds{3})};
  const auto say = [](std::uint32_t agent, std::uint64_t boot, Instant at) {
    AgentState s{};
    s.agent = AgentId{agent};
    s.boot = BootId{boot};
    return Envelope{node(AgentId{agent}), 1, at, s};
  };
  scheduler.step({}, at_s(0));
  scheduler.step({say(1, 1, at_s(1)), say(2, 2, at_s(1)), say(3, 3, at_s(1))}, at_s(1));
  scheduler.step({say(2, 2, at_s(3)), say(3, 3, at_s(3))}, at_s(3));
  scheduler.step({}, at_s(4));  // 1 is lost
  for (const std::uint64_t boot : {1u, 77u}) {
    const Outbox out = scheduler.step({say(1, boot, at_s(5)), say(2, 2, at_s(5))}, at_s(5));
    for (const Body& body : out.messages) {
      const auto* command = std::get_if<Command>(&body);
      CHECK((command == nullptr || command->agent != AgentId{1}));
      CHECK(std::get_if<WorkGrant>(&body) == nullptr);
    }
  }
}

TEST_CASE("scheduler_node: says its state every two seconds and when the phase changes",
          "[scheduler]") {
  const Run run = fly(settings(seconds{3}), quiet_radio, 1, 3);
  MissionPhase phase = MissionPhase::finished;
  for (const Envelope& e : run.log) {
    const auto* state = std::get_if<SchedulerState>(&e.body);
    if (state == nullptr) continue;
    const bool is_even = e.sent.time_since_epoch() % seconds{2} == Duration::zero();
    CHECK((is_even || state->phase != phase));
    phase = state->phase;
  }
  CHECK(phase == MissionPhase::finished);
}

TEST_CASE("scheduler_node: the mission is given up at its limit", "[scheduler]") {
  SchedulerSettings s = settings(seconds{3});
  s.mission_limit = seconds{4};
  const Run run = fly(s, quiet_radio, 1, 3);
  CHECK(run.events("mission_limit").size() == 1);
  const SchedulerState last = run.states().back();
  CHECK(last.phase == MissionPhase::finished);
  CHECK_FALSE(last.completed);
  CHECK(last.open_cells == 0);
  CHECK(last.abandoned_cells > 0);
}

TEST_CASE("scheduler_node: cells that the route leaves out are reported", "[scheduler]") {
  SchedulerSettings s = settings(seconds{3});
  s.plan.route.missed = {at_m(5, 7), at_m(9, 7)};
  const Run run = fly(s, quiet_radio, 1, 3);
  REQUIRE(run.events("cells_missed").size() == 1);
  CHECK(run.events("cells_missed")[0].second.detail.rfind("2 workable cells", 0) == 0);
}

TEST_CASE("scheduler_node: windows of aircraft begin and end", "[scheduler]") {
  // The first stands at its station, so it is called home 30 s before the end; the second is
  // commanded when its window begins.
  SchedulerSettings s = settings(seconds{3});
  s.plan.uavs[0].vehicle.available_until = furrow::seconds(34.0);
  s.plan.uavs[1].vehicle.available_from = furrow::seconds(20.0);
  const Run run = fly(std::move(s), quiet_radio, 1, 3);
  REQUIRE(run.events("agent_taken_out").size() == 1);
  CHECK(run.events("agent_taken_out")[0].first == at_s(4));
  CHECK(run.events("agent_taken_out")[0].second.detail ==
        "agent 1 goes home for good, as its window ends");
  std::optional<Instant> commanded_at;
  for (const Envelope& e : run.log) {
    const auto* command = std::get_if<Command>(&e.body);
    if (command != nullptr && command->agent == AgentId{2} && !commanded_at) commanded_at = e.sent;
  }
  CHECK(commanded_at == at_s(20));
  CHECK(run.states().back().completed);
  for (const auto& [cell, times] : run.sprayed) CHECK(times == 1);
}

}  // namespace
}  // namespace furrow::scheduler
