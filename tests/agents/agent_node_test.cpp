#include "agents/agent_node.hpp"
#include "tests/agents/scripted_fleet.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

namespace furrow::agents {
namespace {

constexpr Instant mission_start{};
constexpr Instant an_hour = mission_start + 3600 * second;

// Three strips of 100 cells, home after the 50th cell of the second.
ScriptedScheduler three_strips() { return {.sorties = two_sorties(strips(3, 100), 149)}; }

std::vector<std::string> event_kinds(const std::vector<Envelope>& log) {
  std::vector<std::string> kinds;
  for (const Event& e : all<Event>(log)) kinds.push_back(e.kind);
  return kinds;
}

bool contains(const std::vector<std::string>& kinds, const std::string& kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

TEST_CASE("agent: sprays each cell once over two sorties, phase by phase", "[agents]") {
  Vehicle v = sprayer();
  v.spray_endurance = seconds(120);  // 360 m
  const auto log = fly(settings_of(v), three_strips(), an_hour);

  CHECK(each_once(log, 300));
  const std::vector<Phase> expected{Phase::idle,     Phase::fly_out,  Phase::spray,
                                    Phase::fly_back, Phase::service,  Phase::fly_out,
                                    Phase::spray,    Phase::fly_back, Phase::done};
  auto seen = phases(log);
  std::erase(seen, Phase::wait);  // shorter than a heartbeat where a bay is free
  CHECK(seen == expected);

  std::vector<AckStatus> acks;
  for (const auto& a : all<CommandAck>(log)) acks.push_back(a.status);
  CHECK(acks ==
        std::vector{AckStatus::received, AckStatus::accepted, AckStatus::running, AckStatus::done});

  const auto sorties = all<SortieReport>(log);
  REQUIRE(sorties.size() == 2);
  // 149 moves of 2 m, the turn of two quarter circles of 1 m shorter by 4 - pi. Coming from (0, 0)
  // the first strip is entered by half an arc of 45 degrees that cuts half of the leg's 1.414 m:
  // 0.707 m become 0.707 / tan(22.5 deg) * 0.3927 = 0.670 m, 0.0367 m less.
  CHECK(sorties[0].sprayed.base() == Approx(298.0 - (4.0 - 3.14159265) - 0.0367).margin(1e-3));
  CHECK(sorties[0].serviced);
  CHECK_FALSE(sorties[0].swapped);
  CHECK(sorties[1].resumed_at == FieldPoint{at_m(3, 101)});
  CHECK_FALSE(sorties[1].serviced);
  // What the second sortie sprays, 300 m less a turn's cut, less what the first left of 360 m.
  CHECK(sorties[0].filled * 360.0 ==
        Approx(sorties[1].sprayed.base() - (360.0 - sorties[0].sprayed.base())).margin(1e-6));
}

TEST_CASE("agent: the valve is open on strips and turns only", "[agents]") {
  const auto log = fly(settings_of(sprayer()), three_strips(), an_hour);
  int spraying = 0;
  for (const auto& record : all<FlightRecord>(log)) {
    for (const TrackPoint& p : record.track) {
      if (!p.spraying) continue;
      ++spraying;
      const double x = p.position.x.base(), y = p.position.y.base();
      const bool is_on_strip = std::abs(std::remainder(x - 1.0, 2.0)) < 0.1;
      const bool is_in_turn = y < 2.1 || y > 197.9;
      CHECK((is_on_strip || is_in_turn));
    }
  }
  CHECK(spraying > 190);  // 596 m at 3 m/s is 199 s
}

TEST_CASE("agent: holds before what is not granted and goes on when it is", "[agents]") {
  auto scheduler = three_strips();
  scheduler.may_grant = [](CellRange cells, Instant now) {
    return cells.first < 100 || now > mission_start + 120 * second;
  };
  const auto log = fly(settings_of(sprayer()), scheduler, an_hour);

  CHECK(each_once(log, 300));
  const auto kinds = event_kinds(log);
  CHECK(contains(kinds, "hold_begun"));
  CHECK(contains(kinds, "hold_ended"));
  for (const auto& e : log) {
    if (const auto* r = std::get_if<FlightRecord>(&e.body)) {
      if (r->cells.count > 0 && r->cells.first >= 100) CHECK(e.sent > mission_start + 120 * second);
    }
  }
  for (const auto& s : all<AgentState>(log)) {
    if (s.phase == Phase::hold) {  // the middle of the turn, 0.29 m inside the corner on each axis
      CHECK(s.position.x.base() == Approx(1.0).margin(0.4));
      CHECK(s.position.y.base() == Approx(199.0).margin(0.4));
    }
  }
}

TEST_CASE("agent: stays on the ground without a grant", "[agents]") {
  auto scheduler = three_strips();
  scheduler.may_grant = [](CellRange, Instant) { return false; };
  const auto log = fly(settings_of(sprayer()), scheduler, mission_start + 60 * second);
  CHECK(phases(log) == std::vector{Phase::idle});
  CHECK(passes(log).empty());
}

TEST_CASE("agent: loss, duplicates and disorder cost time, never a cell", "[agents]") {
  auto scheduler = three_strips();
  scheduler.repeats = 2;
  const Link bad{.latency = Duration{50'000'000},
                 .jitter = Duration{2'000'000'000},
                 .loss = 0.0,
                 .duplication = 0.5};
  CHECK(each_once(fly(settings_of(sprayer()), scheduler, an_hour, bad), 300));
}

TEST_CASE("agent: a low pack brings it home early, and it resumes at the very cell", "[agents]") {
  Vehicle v = sprayer();
  v.flight_endurance = seconds(150);  // 596 m take 199 s and two ways
  v.battery_reserve = 0.1;
  ScriptedScheduler scheduler{.sorties = {{strips(3, 100), StationId{1}}}};
  const auto log = fly(settings_of(v), scheduler, an_hour);

  CHECK(each_once(log, 300));
  CHECK(contains(event_kinds(log), "return_early"));
  const auto sorties = all<SortieReport>(log);
  REQUIRE(sorties.size() >= 2);
  CHECK(sorties[0].swapped);
  CHECK(distance(sorties[0].returned_at, sorties[1].resumed_at).base() < 0.3);
  bool is_closed_in_part = false;
  for (const auto& report : all<WorkReport>(log)) {
    for (const auto& c : report.closures) {
      is_closed_in_part |= c.reason == CloseReason::battery_low && c.sprayed < c.cells.count;
    }
  }
  CHECK(is_closed_in_part);
  for (const auto& s : all<AgentState>(log)) CHECK(s.battery >= 0.1);
}

TEST_CASE("agent: a tank too small brings it home, never below zero, and adds up", "[agents]") {
  Vehicle v = sprayer();
  v.spray_endurance = seconds(80);  // 240 m of 600
  ScriptedScheduler scheduler{.sorties = {{strips(3, 100), StationId{1}}}};
  const auto log = fly(settings_of(v), scheduler, an_hour);

  CHECK(each_once(log, 300));
  double filled = 1.0, sprayed_m = 0.0;
  for (const auto& s : all<SortieReport>(log)) {
    filled += s.filled;
    sprayed_m += s.sprayed.base();
    CHECK(s.sprayed.base() <= 240.001);
  }
  const auto states = all<AgentState>(log);
  for (const auto& s : states) CHECK(s.tank >= -1e-12);
  CHECK(filled - sprayed_m / 240.0 == Approx(states.back().tank).margin(1e-4));
}

TEST_CASE("agent: flies the same track at whatever instants it is stepped", "[agents]") {
  const auto settings = settings_of(
      sprayer(), {.mean = metres_per_second(6), .from_deg = 270, .gust = metres_per_second(1.5)});
  const Command command{agent_7, boot_1, Epoch{1}, 1, two_sorties(strips(3, 100), 149)};
  const WorkGrant grant{agent_7, boot_1, Epoch{1}, 1, 0, {{1, {0, 100}}, {2, {100, 50}}}};
  const auto track = [&](Duration stride) {
    AgentNode agent{settings};
    std::vector<TrackPoint> points;
    const auto keep = [&](const Outbox& out) {
      for (const auto& body : out.messages) {
        if (const auto* r = std::get_if<FlightRecord>(&body)) {
          points.insert(points.end(), r->track.begin(), r->track.end());
        }
      }
      return out.wake;
    };
    keep(agent.step({}, mission_start));
    Instant wake = keep(agent.step({{scheduler_node(), 1, mission_start, command},
                                    {scheduler_node(), 2, mission_start, grant}},
                                   mission_start + Duration{1'230'000'000}));
    for (Instant t = mission_start + second + second; t < mission_start + 200 * second;) {
      wake = keep(agent.step({}, t));
      t = stride.count() > 0 ? t + stride : wake;
    }
    return points;
  };

  const auto woken = track({}), fine = track(Duration{37'000'000}), coarse = track(7 * second);
  REQUIRE(woken.size() > 100);
  for (const auto* other : {&fine, &coarse}) {
    REQUIRE(other->size() == woken.size());
    for (std::size_t i = 0; i < woken.size(); ++i) {
      REQUIRE((*other)[i].at == woken[i].at);
      REQUIRE((*other)[i].position == woken[i].position);
    }
  }
}

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

// Steps an agent once a second under `told`, by second; everything that it says.
std::vector<Envelope> told_by_second(AgentNode& agent, const std::map<int, std::vector<Body>>& told,
                                     int to_s) {
  std::vector<Envelope> log;
  std::uint64_t seq = 0;
  for (int s = 0; s < to_s; ++s) {
    const Instant now = mission_start + s * second;
    Inbox inbox;
    if (const auto at = told.find(s); at != told.end()) {
      for (const Body& body : at->second) inbox.push_back({scheduler_node(), ++seq, now, body});
    }
    for (Body& body : agent.step(inbox, now).messages) {
      log.push_back({node(agent_7), log.size() + 1, now, std::move(body)});
    }
  }
  return log;
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

TEST_CASE("agent: a gust that blows it off its line closes the valve, and it comes back",
          "[agents]") {
  Vehicle v = sprayer();
  v.acceleration_limit = metres_per_second2(0.6);
  v.ferry_speed = metres_per_second(12);  // workable up to 12 + 2 * 0.6 m/s
  v.flight_endurance = seconds(3000);
  const Wind rough{.mean = metres_per_second(4), .from_deg = 270, .gust = metres_per_second(4)};
  const auto log = fly(settings_of(v, rough), three_strips(), an_hour);
  REQUIRE(contains(event_kinds(log), "off_line"));
  CHECK(each_once(log, 300));
  // Half a swath of 1 m, and what it moves within a period and the lag of one.
  for (const auto& record : all<FlightRecord>(log)) {
    for (const float offset_m : record.offsets_m) CHECK(std::abs(offset_m) < 1.0 + 0.3);
    for (const TrackPoint& p : record.track) {
      if (p.spraying) CHECK(p.position.x.base() == Approx(3.0).margin(2.0 + 1.0 + 0.3));
    }
  }
}

TEST_CASE("agent: one that cannot be kept on its line comes home and gives its work back",
          "[agents]") {
  Vehicle v = sprayer();
  v.acceleration_limit = metres_per_second2(0.5);
  v.ferry_speed = metres_per_second(12);
  v.swath = metres(1.2);  // of strips 2 m apart
  v.flight_endurance = seconds(3000);
  const Wind wild{.mean = {}, .from_deg = 270, .gust = metres_per_second(6)};
  const auto log = fly(settings_of(v, wild), three_strips(), an_hour);
  CHECK(contains(event_kinds(log), "return_early"));
  CHECK(all<CommandAck>(log).back().status == AckStatus::failed);
  CHECK(all<AgentState>(log).back().phase == Phase::offline);
  std::uint32_t closed = 0;
  const auto reports = all<WorkReport>(log);
  for (const auto& closure : reports.back().closures) {
    CHECK(closure.reason == CloseReason::strayed);
    closed += closure.sprayed < closure.cells.count;
  }
  CHECK(closed > 0);
  for (const auto& [cell, times] : passes(log)) CHECK(times == 1);
}

TEST_CASE("agent: without a scheduler it sprays what was granted and no more, then comes home",
          "[agents]") {
  Vehicle v = sprayer();
  v.flight_endurance = seconds(300);
  auto scheduler = three_strips();
  scheduler.silent_from = mission_start + 20 * second;  // two windows are granted
  const auto log = fly(settings_of(v), scheduler, an_hour);

  CHECK(contains(event_kinds(log), "scheduler_silent"));
  CHECK(each_once(log, 150));  // the first strip and the first half of the second
  const auto states = all<AgentState>(log);
  CHECK((states.back().position == at_m(0, 0) ||
         distance(states.back().position, at_m(0, 0)).base() < 1.0));
  CHECK((states.back().phase == Phase::wait || states.back().phase == Phase::service));
  // Closed within a second of the last granted cell, wherever it then is.
  bool is_open = false;
  for (const auto& record : all<FlightRecord>(log)) {
    for (const TrackPoint& p : record.track) is_open = p.spraying;
  }
  CHECK_FALSE(is_open);
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
