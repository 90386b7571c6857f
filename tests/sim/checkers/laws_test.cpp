#include "sim/checkers/clearance.hpp"
#include "tests/sim/checkers/scripted_log.hpp"

#include <catch2/catch.hpp>

namespace furrow::sim {
namespace {

TEST_CASE("laws: L17 a gap or a step back in the log", "[sim]") {
  Script gap = clean_run();
  gap.seq[scheduler_node()] = 7;
  gap.say(scheduler_node(), 6, finished(4, 0));
  CHECK(broken_laws(facts(), gap) == Laws{"L17"});

  Script back = clean_run();
  back.say(scheduler_node(), 4, finished(4, 0));
  CHECK(broken_laws(facts(), back) == Laws{"L17"});
}

TEST_CASE("laws: L22 a track too near to an obstacle that the plan flies around", "[sim]") {
  // A tree of 0.5 m, 1 m of safety: nine tenths of it are left at 1.4 m from its centre.
  Facts f = facts();
  f.field.obstacles = {{"tree", at_m(20, 4), metres(0.5)}};
  const auto broken_at = [&](double away_m) {
    Script s = clean_run();
    FlightRecord record = flight({0, 0});
    record.track = {{at(6), at_m(20 - away_m, 4), false}};
    s.say(node(one), 6, record);
    s.say(scheduler_node(), 7, finished(4, 0));
    return broken_laws(f, s);
  };
  CHECK(broken_at(1.3).empty());  // no distance to keep
  f.plan.safety = metres(1);
  CHECK(broken_at(1.41).empty());
  CHECK(broken_at(1.39) == std::vector<std::string>{"L22"});
  f.plan.uavs[0].vehicle.gnss.bias = metres(0.5);
  CHECK(broken_at(1.0).empty());
  f.plan.uavs[0].vehicle.gnss = {.sigma = metres(0.12), .bias = {}};  // 0.4 m more than an RTK's
  CHECK(broken_at(1.01).empty());
  CHECK(broken_at(0.99) == Laws{"L22"});
}

TEST_CASE("the least clearance is told of the nearest obstacle, round or an outline", "[sim]") {
  Facts f = facts();
  f.plan.safety = metres(1);
  f.field.obstacles = {
      {"tree", at_m(20, 4), metres(0.5)},
      outlined("pond", {at_m(-40, 10), at_m(60, 10), at_m(60, 30), at_m(-40, 30)})};
  Script s = clean_run();
  FlightRecord record = flight({0, 0});
  // 3 m from the tree's edge, then 1.5 m; 1.25 m from the pond's.
  record.track = {
      {at(5), at_m(16.5, 4), false}, {at(6), at_m(18, 4), false}, {at(7), at_m(2, 8.75), false}};
  s.say(node(one), 7, record);
  const auto least = least_clearance(f, s.log);
  REQUIRE(least);
  CHECK(least->obstacle == "pond");
  CHECK(least->agent == one);
  CHECK(least->away.base() == Approx(1.25));
  CHECK(least->at == at(7));
  f.plan.safety = metres(0);
  CHECK_FALSE(least_clearance(f, s.log));
}

TEST_CASE("laws: L22 a track too near to an outline", "[sim]") {
  // A pond whose southern edge is at y = 10: 0.9 m of 1 m are left at y = 9.1.
  Facts f = facts();
  f.plan.safety = metres(1);
  f.field.obstacles = {
      outlined("pond", {at_m(-40, 10), at_m(60, 10), at_m(60, 30), at_m(-40, 30)})};
  const auto broken_at = [&](double y_m) {
    Script s = clean_run();
    FlightRecord record = flight({0, 0});
    record.track = {{at(6), at_m(2, y_m), false}};
    s.say(node(one), 6, record);
    s.say(scheduler_node(), 7, finished(4, 0));
    return broken_laws(f, s);
  };
  CHECK(broken_at(9.09).empty());
  CHECK(broken_at(9.11) == Laws{"L22"});
  CHECK(broken_at(20) == Laws{"L22"});
}

TEST_CASE("laws: L22 a track too near to an obstacle that no plan knows, once it is there",
          "[sim]") {
  // As above, at 1.39 m from the centre at 6 s.
  const auto broken_from = [](double appears_s) {
    Facts f = facts();
    f.plan.safety = metres(1);
    f.surprises = {{.id = "tree",
                    .obstacle = {at_m(20, 4), metres(0.5)},
                    .appears = at(appears_s),
                    .seen_within = metres(20)}};
    Script s = clean_run();
    FlightRecord record = flight({0, 0});
    record.track = {{at(6), at_m(18.61, 4), false}};
    s.say(node(one), 6, record);
    s.say(scheduler_node(), 7, finished(4, 0));
    return broken_laws(f, s);
  };
  CHECK(broken_from(0) == std::vector<std::string>{"L22"});
  CHECK(broken_from(6.5).empty());
}

TEST_CASE("laws: L22 nobody avoids what comes up within the way in which he stops", "[sim]") {
  // Northwards at 4 m/s, 2 m before the edge of a tree that comes up at 6 s: at 3 m/s2 at most it
  // stops in 2.7 m. It is excused until it has been clear of it once.
  const auto broken_by = [](double appears_s, std::vector<double> later_y_m) {
    Facts f = facts();
    f.plan.safety = metres(1);
    f.surprises = {{.id = "tree",
                    .obstacle = {at_m(2, 12), metres(0.5)},
                    .appears = at(appears_s),
                    .seen_within = metres(20)}};
    Script s = clean_run();
    FlightRecord record = flight({0, 0});
    record.track = {{at(5), at_m(2, 5.5), false}, {at(6), at_m(2, 9.5), false}};
    double t = 7;
    for (const double y_m : later_y_m) record.track.push_back({at(t++), at_m(2, y_m), false});
    s.say(node(one), 6, record);
    s.say(scheduler_node(), 7, finished(4, 0));
    return broken_laws(f, s);
  };
  CHECK(broken_by(5.9, {11, 11, 9}).empty());
  CHECK(broken_by(5.9, {11, 9, 11}) == Laws{"L22"});  // came back
  CHECK(broken_by(4.9, {11}) == Laws{"L22"});         // it was there before
}

TEST_CASE("laws: L21 messages of strangers are told once and judged no further", "[sim]") {
  constexpr AgentId stranger{9};
  Script s = clean_run();
  SECTION("an agent's state, flight, report, sortie and claim") {
    AgentState state = heard(Phase::spray, 0.0, at_m(0, 1000));
    state.agent = stranger;
    s.say(node(stranger), 6, state);
    FlightRecord record = flight({0, 0});
    record.agent = stranger;
    record.track = {{at(6), at_m(500, 500), true}};
    s.say(node(stranger), 6, record);
    SortieReport sortie{};
    sortie.agent = stranger;
    s.say(node(stranger), 6, sortie);
    WorkReport report{.agent = stranger, .boot = BootId{1}, .epoch = Epoch{1}, .closures = {}};
    s.say(node(stranger), 6, report);
    s.say(node(stranger), 6, claim(stranger, ClaimStatus::waiting, 0, 6));
    s.say(node(depot), 6.5, bay_one(stranger, 1, 6.5));
  }
  SECTION("a station's state") {
    s.say(node(StationId{9}), 6,
          StationState{.station = StationId{9},
                       .bays = {},
                       .queue = {},
                       .swaps = 0,
                       .filled = {},
                       .open_bays = 1});
  }
  s.say(scheduler_node(), 7, finished(4, 0));
  CHECK(broken_laws(facts(), s) == Laws{"L21"});
}

TEST_CASE("laws: L26 an aircraft in the air before or after the time it is available for",
          "[sim]") {
  Facts f = facts();
  f.whole = false;
  f.plan.uavs[0].vehicle.available_from = seconds(2);
  f.plan.uavs[0].vehicle.available_until = seconds(5);
  const auto told_at = [&](double at_s, Phase phase) {
    Script s;
    AgentState state{};
    state.agent = one;
    state.phase = phase;
    s.say(node(one), at_s, state);
    std::size_t told = 0;
    for (const Violation& v : violations(f, s.log, at(6))) told += v.law == "L26" ? 1 : 0;
    return told;
  };
  CHECK(told_at(1.9, Phase::fly_out) == 1);
  CHECK(told_at(1.9, Phase::idle) == 0);
  CHECK(told_at(2, Phase::fly_out) == 0);
  CHECK(told_at(5, Phase::fly_back) == 0);
  CHECK(told_at(5.1, Phase::fly_back) == 1);
  CHECK(told_at(5.1, Phase::done) == 0);
}

}  // namespace
}  // namespace furrow::sim
