#include "agents/agent_node.hpp"
#include "tests/agents/scripted_fleet.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

namespace furrow::agents {
namespace {

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

TEST_CASE("agent: flies with the last of the mix, and gives up its work when that is sprayed",
          "[agents]") {
  Vehicle v = sprayer();
  v.spray_endurance = seconds(80);  // 240 m of 600
  ScriptedScheduler scheduler{.sorties = {{strips(3, 100), StationId{1}}}};
  const auto log = fly(settings_of(v), scheduler, an_hour, radio, {.tanks_left = 0.5});

  // One tank and a half are 360 m: 180 cells of 300, less those that it stops before being empty.
  const auto sprayed = passes(log);
  CHECK(each_once(log, static_cast<std::uint32_t>(sprayed.size())));
  CHECK(sprayed.size() <= 180);
  CHECK(sprayed.size() >= 165);
  CHECK(all<SortieReport>(log).size() == 2);
  CHECK(all<AgentState>(log).back().phase == Phase::offline);
  const auto last = all<CommandAck>(log).back();
  CHECK(last.status == AckStatus::failed);
  CHECK(last.reason == "station 1 has no mix for it");
  std::uint32_t reported = 0;
  for (const auto& report : all<WorkReport>(log)) {
    for (const Closure& c : report.closures) {
      if (c.sprayed > 0) reported = std::max(reported, c.cells.first + c.sprayed);
    }
  }
  CHECK(reported == sprayed.size());  // nothing is lost of it
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

}  // namespace
}  // namespace furrow::agents
