#include "agents/agent_node.hpp"
#include "tests/agents/scripted_fleet.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

namespace furrow::agents {
namespace {

TEST_CASE("agent: an old epoch and a foreign incarnation are not obeyed", "[agents]") {
  AgentNode agent{settings_of(sprayer())};
  const auto sorties = two_sorties(strips(3, 100), 149);
  std::uint64_t seq = 0;
  Instant now = mission_start;
  const auto tell = [&](Body body) {
    now += second;
    return agent.step({{scheduler_node(), ++seq, now, std::move(body)}}, now).messages;
  };
  const auto acks = [](const std::vector<Body>& said) {
    return std::count_if(said.begin(), said.end(),
                         [](const Body& b) { return std::holds_alternative<CommandAck>(b); });
  };
  agent.step({}, now);
  CHECK(acks(tell(Command{agent_7, BootId{9}, Epoch{2}, 1, sorties})) == 0);
  CHECK(acks(tell(Command{agent_7, boot_1, Epoch{2}, 1, sorties})) == 2);
  CHECK(acks(tell(Command{agent_7, boot_1, Epoch{1}, 5, sorties})) == 0);
  tell(WorkGrant{agent_7, boot_1, Epoch{1}, 1, 0, {{1, {0, 100}}}});  // of the fenced-off epoch
  SchedulerState old{};
  old.epoch = Epoch{1};
  const auto said = tell(old);
  for (const Body& b : said) {
    if (const auto* s = std::get_if<AgentState>(&b)) CHECK(s->phase == Phase::idle);
  }
}

TEST_CASE("agent: a newer revision in the air closes the old windows and is flown", "[agents]") {
  AgentNode agent{settings_of(sprayer())};
  const std::vector<SortieOrder> first{{strips(3, 100), StationId{1}}};
  auto rest = strips(3, 100);
  rest.erase(rest.begin(), rest.begin() + 2);
  rest.front().entry = rest.front().from;
  agent.step({}, mission_start);
  agent.step(
      {{scheduler_node(), 1, {}, Command{agent_7, boot_1, Epoch{1}, 1, first}},
       {scheduler_node(), 2, {}, WorkGrant{agent_7, boot_1, Epoch{1}, 1, 0, {{1, {0, 100}}}}}},
      mission_start + second);
  std::vector<Envelope> log;
  const auto run = [&](Inbox inbox, int from_s, int to_s) {
    for (int s = from_s; s < to_s; ++s) {
      for (auto& body : agent.step(std::exchange(inbox, {}), mission_start + s * second).messages) {
        log.push_back({node(agent_7), log.size(), {}, std::move(body)});
      }
    }
  };
  run({}, 2, 20);
  run({{scheduler_node(), 3, {}, Command{agent_7, boot_1, Epoch{1}, 2, {{rest, StationId{1}}}}}},
      20, 30);
  const auto reports = all<WorkReport>(log);
  REQUIRE_FALSE(reports.empty());
  CHECK(reports.back().closures.back().reason == CloseReason::superseded);
  run({{scheduler_node(), 4, {}, WorkGrant{agent_7, boot_1, Epoch{1}, 2, 1, {{2, {200, 100}}}}}},
      30, 250);
  CHECK(passes(log)[250] == 1);
  CHECK(all<AgentState>(log).back().phase == Phase::done);
}

TEST_CASE("agent: a revision that only adds sorties is taken up without a stop", "[agents]") {
  const auto ordered = two_sorties(strips(3, 100), 149);
  const std::vector<SortieOrder> before{ordered[0]};
  const Command first{agent_7, boot_1, Epoch{1}, 1, before};
  const Command revised{agent_7, boot_1, Epoch{1}, 2, ordered};
  const WorkGrant two{agent_7, boot_1, Epoch{1}, 1, 0, {{1, {0, 100}}, {2, {100, 50}}}};
  const WorkGrant all_four{agent_7, boot_1, Epoch{1}, 2, 2, {{3, {150, 50}}, {4, {200, 100}}}};
  // Cell 60 is passed 40 s after take-off, the last of the sortie after 100 s; it is home, with all
  // of the first order done, after 120 s.
  for (const int revised_s : {40, 101, 105, 180}) {
    CAPTURE(revised_s);
    AgentNode agent{settings_of(sprayer())};
    const auto log = told_by_second(
        agent, {{1, {first}}, {2, {two}}, {revised_s, {revised}}, {revised_s + 1, {all_four}}},
        500);
    CHECK(each_once(log, 300));
    for (const auto& report : all<WorkReport>(log)) {
      for (const Closure& c : report.closures) CHECK(c.reason == CloseReason::sprayed);
    }
    CHECK_FALSE(contains(event_kinds(log), "hold_begun"));
    CHECK(all<SortieReport>(log).size() == 2);
    CHECK(all<AgentState>(log).back().phase == Phase::done);
  }
}

TEST_CASE("agent: a revision that takes the rest away brings it home, done", "[agents]") {
  const auto ordered = two_sorties(strips(3, 100), 149);
  const Command first{agent_7, boot_1, Epoch{1}, 1, ordered};
  const Command shorter{agent_7, boot_1, Epoch{1}, 2, {ordered[0]}};
  const WorkGrant two{agent_7, boot_1, Epoch{1}, 1, 0, {{1, {0, 100}}, {2, {100, 50}}}};
  for (const int revised_s :
       {40, 105, 180}) {  // in the air at work, on the way home, on the ground
    CAPTURE(revised_s);
    AgentNode agent{settings_of(sprayer())};
    const auto log = told_by_second(agent, {{1, {first}}, {2, {two}}, {revised_s, {shorter}}}, 300);
    CHECK(each_once(log, 150));
    CHECK(all<AgentState>(log).back().phase == Phase::done);
    CHECK(all<CommandAck>(log).back().status == AckStatus::done);
  }
}

TEST_CASE("agent: rejects what cannot be flown, and says why", "[agents]") {
  const auto answer = [](const AgentSettings& settings, std::vector<SortieOrder> sorties) {
    AgentNode agent{settings};
    agent.step({}, mission_start);
    const auto out = agent.step(
        {{scheduler_node(), 1, {}, Command{agent_7, boot_1, Epoch{1}, 1, std::move(sorties)}}},
        mission_start + second);
    for (const Body& b : out.messages) {
      const auto* ack = std::get_if<CommandAck>(&b);
      if (ack && ack->status == AckStatus::rejected) return ack->reason;
    }
    return std::string{"accepted"};
  };
  const auto calm = settings_of(sprayer());
  auto broken = strips(2, 10);
  broken[1].cells.first = 5;
  CHECK(answer(calm, {{strips(2, 10), StationId{1}}}) == "accepted");
  CHECK(answer(calm, {{strips(2, 10), StationId{4}}}) == "station 4 is unknown");
  CHECK(answer(calm, {{broken, StationId{1}}}) == "cell 5 is ordered twice");
  // Thrust 3 + 0.25 * 12 = 6 m/s2; half of 3 kept back; 4.5 / 0.25 - 6 = 12 m/s.
  CHECK(answer(settings_of(sprayer(), {.mean = metres_per_second(14), .from_deg = 0, .gust = {}}),
               {{strips(2, 10), StationId{1}}}) ==
        "gusts of 14.0 m/s leave no headway, 12.0 m/s is the most");
}

TEST_CASE("agent: refuses what a 10 Hz autopilot cannot hold, and says why", "[agents]") {
  const auto answer = [](const Vehicle& v) {
    const auto acks = all<CommandAck>(fly(
        settings_of(v), {.sorties = {{strips(2, 10), StationId{1}}}}, mission_start + 2 * second));
    REQUIRE_FALSE(acks.empty());
    return acks.front().reason;
  };
  Vehicle fast = sprayer();  // 10 m/s are 1 m a period, half a swath of 2 m
  fast.spray_speed = metres_per_second(10);
  CHECK(answer(fast).empty());
  fast.spray_speed = metres_per_second(30);
  CHECK(answer(fast) ==
        "no autopilot of 10 Hz holds 30.0 m/s on a swath of 2.00 m, 10.0 m/s is the most");
  fast = sprayer();
  fast.ferry_speed = metres_per_second(20.1);
  CHECK(answer(fast) ==
        "no autopilot of 10 Hz holds 20.1 m/s on a swath of 2.00 m, 20.0 m/s is the most");
  // pi / 2 m of arc at sqrt(0.9 * 0.95 * 50 m/s2 * 1 m) = 6.54 m/s.
  fast = sprayer();
  fast.spray_speed = metres_per_second(10);
  fast.acceleration_limit = metres_per_second2(50);
  CHECK(answer(fast) ==
        "it turns a corner of half a swath of 2.00 m in 0.24 s, no autopilot of 10 Hz holds less "
        "than 0.50 s");
  Vehicle lame = sprayer();
  lame.acceleration_limit = metres_per_second2(0.1);
  CHECK(answer(lame) ==
        "an acceleration of 0.10 m/s2 does not hold it on its line, 0.50 m/s2 is the least");
}

TEST_CASE("agent: a lost answer to a command is given again when the command is", "[agents]") {
  const Link lossy{.latency = Duration{50'000'000}, .jitter = {}, .loss = 0.3, .duplication = 0};
  auto scheduler = three_strips();
  const auto log = fly(settings_of(sprayer()), scheduler, an_hour, lossy);
  CHECK(each_once(log, 300));

  AgentNode agent{settings_of(sprayer())};
  const Command command{agent_7, boot_1, Epoch{1}, 1, scheduler.sorties};
  agent.step({}, mission_start);
  std::vector<AckStatus> answers;
  for (int s = 1; s <= 3; ++s) {
    const auto seq = static_cast<std::uint64_t>(s);
    const Instant now = mission_start + s * second;
    for (const Body& b : agent.step({{scheduler_node(), seq, now, command}}, now).messages) {
      if (const auto* ack = std::get_if<CommandAck>(&b)) answers.push_back(ack->status);
    }
  }
  CHECK(answers == std::vector{AckStatus::received, AckStatus::accepted, AckStatus::accepted,
                               AckStatus::accepted});
}

}  // namespace
}  // namespace furrow::agents
