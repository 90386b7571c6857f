#include "sim/checkers/laws.hpp"

#include <catch2/catch.hpp>
#include <map>

namespace furrow::sim {
namespace {

constexpr AgentId one{1}, two{2};
constexpr StationId depot{1};

Instant at(double s) { return instant(seconds(s)); }

Vehicle vehicle(AgentId id) {
  return {.id = id,
          .home = at_m(0, 0),
          .swath = metres(2),
          .spray_speed = metres_per_second(3),
          .ferry_speed = metres_per_second(6),
          .spray_endurance = seconds(100),
          .flight_endurance = seconds(1000),
          .battery_reserve = 0.1,
          .tank = litres(10),
          .min_turn_radius = metres(0),
          .acceleration_limit = metres_per_second2(3),
          .gnss = {.sigma = metres(0), .bias = metres(0)}};
}

// One strip of four cells along y at x = 1; two aircraft; a station with one bay at the origin.
Facts facts() {
  const Station station{.id = depot,
                        .position = at_m(0, 0),
                        .bays = 1,
                        .battery_swap = seconds(60),
                        .fill_base = seconds(20),
                        .fill_full = seconds(60)};
  Facts f{.field = {.boundary = {at_m(0, 0), at_m(2, 0), at_m(2, 8), at_m(0, 8)},
                    .holes = {},
                    .obstacles = {}},
          .stations = {station},
          .plan = {},
          .claim_lease = duration(seconds(3)),
          .whole = true};
  f.plan.route.cell = metres(2);
  f.plan.route.centers = {at_m(1, 1), at_m(1, 3), at_m(1, 5), at_m(1, 7)};
  for (const AgentId id : {one, two}) {
    scheduler::UavPlan uav{};
    uav.vehicle = vehicle(id);
    uav.station = station;
    f.plan.uavs.push_back(uav);
  }
  return f;
}

// A log under construction: numbers and times the messages.
struct Script {
  std::vector<Envelope> log;
  std::map<NodeId, std::uint64_t> seq;
  void say(NodeId from, double s, Body body) { log.push_back({from, ++seq[from], at(s), body}); }
};

SchedulerState finished(std::uint32_t sprayed, std::uint32_t abandoned) {
  return {.epoch = Epoch{1},
          .phase = MissionPhase::finished,
          .completed = abandoned == 0,
          .sprayed_cells = sprayed,
          .open_cells = 0,
          .abandoned_cells = abandoned,
          .lost = {}};
}

WorkGrant grant(std::uint64_t id, CellRange cells) {
  return {.agent = one,
          .target_boot = BootId{1},
          .epoch = Epoch{1},
          .revision = 1,
          .closed_through = 0,
          .windows = {{id, cells}}};
}

FlightRecord flight(CellRange cells) {
  FlightRecord record{};
  record.agent = one;
  record.cells = cells;
  record.offsets_m.assign(cells.count, 0.0F);
  return record;
}

WorkReport closure(std::uint64_t id, CellRange cells, std::uint32_t sprayed) {
  return {.agent = one,
          .boot = BootId{1},
          .epoch = Epoch{1},
          .closures = {{id, cells, sprayed, CloseReason::sprayed, at(5)}}};
}

// All four cells granted, sprayed and booked.
Script clean_run() {
  Script s;
  s.say(scheduler_node(), 1, grant(1, {0, 4}));
  s.say(node(one), 5, flight({0, 4}));
  s.say(node(one), 5, closure(1, {0, 4}, 4));
  return s;
}

std::vector<std::string> broken_laws(const Facts& f, const Script& s) {
  std::vector<std::string> laws;
  for (const Violation& v : violations(f, s.log, at(100))) laws.push_back(v.law);
  return laws;
}

ServiceClaim claim(AgentId agent, ClaimStatus status, std::uint64_t token, double first_s) {
  return {.agent = agent,
          .boot = BootId{1},
          .station = depot,
          .claim = 1,
          .first_claimed = at(first_s),
          .status = status,
          .token = token,
          .swap = true,
          .fill = 0.5};
}

ServiceGrant bay_one(AgentId agent, std::uint64_t token, double s) {
  return {.agent = agent,
          .station = depot,
          .claim = 1,
          .bay = 1,
          .token = token,
          .starts = at(s),
          .ready = at(s + 60),
          .expires = at(s + 3)};
}

using Laws = std::vector<std::string>;

TEST_CASE("laws: a clean run breaks none", "[sim]") {
  Script s = clean_run();
  s.say(scheduler_node(), 6, finished(4, 0));
  CHECK(broken_laws(facts(), s) == Laws{});
}

TEST_CASE("laws: L1 a cell sprayed twice, in truth or on the books", "[sim]") {
  Script flown = clean_run();
  flown.say(node(one), 5.5, flight({3, 1}));
  flown.say(scheduler_node(), 6, finished(4, 0));
  CHECK(broken_laws(facts(), flown) == Laws{"L1"});

  Script booked = clean_run();
  booked.say(scheduler_node(), 5.2, grant(2, {3, 1}));
  booked.say(node(one), 5.5, closure(2, {3, 1}, 1));
  booked.say(scheduler_node(), 6, finished(4, 0));
  CHECK(broken_laws(facts(), booked) == Laws{"L1"});
}

TEST_CASE("laws: L2 a cell nobody answers for", "[sim]") {
  Script s = clean_run();
  SECTION("the counts do not add up") { s.say(scheduler_node(), 6, finished(3, 0)); }
  SECTION("the ledger claims more than was closed") {
    s.log.pop_back();
    s.seq[node(one)] = 1;
    s.say(scheduler_node(), 6, finished(4, 0));
  }
  const Laws laws = broken_laws(facts(), s);
  REQUIRE_FALSE(laws.empty());
  CHECK(laws.front() == "L2");
}

TEST_CASE("laws: L5 the valve open outside the field", "[sim]") {
  Script s = clean_run();
  FlightRecord stray = flight({0, 0});
  // Half a swath is 1 m: 0.9 m outside is the boom's edge, 1.1 m is a fault.
  stray.track = {
      {at(4), at_m(2.9, 3), true}, {at(5), at_m(3.1, 3), true}, {at(5), at_m(9.0, 3), false}};
  s.say(node(one), 5.5, stray);
  s.say(scheduler_node(), 6, finished(4, 0));
  CHECK(broken_laws(facts(), s) == Laws{"L5"});
}

TEST_CASE("laws: L5 a dose that does not fit the cells", "[sim]") {
  Script s = clean_run();
  SortieReport sortie{};
  sortie.agent = one;
  // Four cells of 2 m are 8 m; 2 %, two cells and half a cell for the piece are allowed: 13.16 m.
  SECTION("within tolerance") {
    sortie.sprayed = metres(13.1);
    s.say(node(one), 5.5, sortie);
    s.say(scheduler_node(), 6, finished(4, 0));
    CHECK(broken_laws(facts(), s) == Laws{});
  }
  SECTION("beyond it") {
    sortie.sprayed = metres(13.2);
    s.say(node(one), 5.5, sortie);
    s.say(scheduler_node(), 6, finished(4, 0));
    CHECK(broken_laws(facts(), s) == Laws{"L5"});
  }
}

TEST_CASE("laws: L6 work without a grant, and a grant that changes or goes back", "[sim]") {
  Script ungranted;
  ungranted.say(scheduler_node(), 1, grant(1, {0, 3}));
  ungranted.say(node(one), 5, flight({0, 4}));
  CHECK(broken_laws(facts(), ungranted).front() == "L6");

  Script changed = clean_run();
  changed.say(scheduler_node(), 5.5, grant(1, {0, 3}));
  changed.say(scheduler_node(), 6, finished(4, 0));
  CHECK(broken_laws(facts(), changed) == Laws{"L6"});
}

TEST_CASE("laws: L7 and L8 energy and tank", "[sim]") {
  Script s = clean_run();
  AgentState state{};
  state.agent = one;
  state.phase = Phase::spray;
  state.tank = 0.97;  // 8 m of 300 m are sprayed
  // 60 m from home at 6 m/s is 10 s, 0.01 of a pack of 1000 s; with the reserve 0.11.
  state.position = at_m(0, 60);
  SECTION("enough for the way home") { state.battery = 0.1101; }
  SECTION("too little for it") { state.battery = 0.1099; }
  SECTION("below the reserve") { state.battery = 0.0999; }
  SECTION("an empty tank is no debt") {
    state.battery = 0.5;
    state.tank = -0.01;
  }
  s.say(node(one), 5.5, state);
  s.say(scheduler_node(), 6, finished(4, 0));
  const Laws expected = state.tank < 0         ? Laws{"L8", "L8"}  // when heard, and at the end
                        : state.battery < 0.1  ? Laws{"L8", "L7"}
                        : state.battery < 0.11 ? Laws{"L7"}
                                               : Laws{};
  CHECK(broken_laws(facts(), s) == expected);
}

TEST_CASE("laws: L9 two in a bay, L11 out of turn", "[sim]") {
  Script s = clean_run();
  s.say(node(one), 10, claim(one, ClaimStatus::waiting, 0, 10));
  s.say(node(StationId{1}), 10.1, bay_one(one, 1, 10.1));
  s.say(node(one), 11, claim(one, ClaimStatus::in_bay, 1, 10));
  s.say(node(two), 11, claim(two, ClaimStatus::waiting, 0, 11));
  SECTION("a bay is given away while it is held") {
    s.say(node(StationId{1}), 12, bay_one(two, 2, 12));
    s.say(scheduler_node(), 20, finished(4, 0));
    CHECK(broken_laws(facts(), s) == Laws{"L9"});
  }
  SECTION("a bay is given on when it is free") {
    s.say(node(one), 12, claim(one, ClaimStatus::released, 1, 10));
    s.say(node(StationId{1}), 12.1, bay_one(two, 2, 12.1));
    s.say(scheduler_node(), 20, finished(4, 0));
    CHECK(broken_laws(facts(), s) == Laws{});
  }
  SECTION("a later claim is served before an earlier one") {
    s.say(node(one), 12, claim(one, ClaimStatus::released, 1, 10));
    ServiceClaim again = claim(one, ClaimStatus::waiting, 0, 13);
    again.claim = 2;
    s.say(node(one), 13, again);
    s.say(node(two), 13, claim(two, ClaimStatus::waiting, 0, 11));
    ServiceGrant early = bay_one(one, 2, 14);
    early.claim = 2;
    s.say(node(StationId{1}), 14, early);
    s.say(scheduler_node(), 20, finished(4, 0));
    CHECK(broken_laws(facts(), s) == Laws{"L11"});
  }
}

TEST_CASE("laws: L10 a bay held by the dead, L12 a refill counted twice", "[sim]") {
  Script s = clean_run();
  s.say(node(one), 10, claim(one, ClaimStatus::waiting, 0, 10));
  s.say(node(StationId{1}), 10.1, bay_one(one, 1, 10.1));
  StationState state{
      .station = depot,
      .bays = {{.bay = 1, .occupied = true, .agent = one, .token = 1, .ready = at(70)}},
      .queue = {},
      .swaps = 1,
      .filled = litres(5)};
  SECTION("within lease and grace") {
    s.say(node(StationId{1}), 14.9, state);
    s.say(scheduler_node(), 20, finished(4, 0));
    CHECK(broken_laws(facts(), s) == Laws{});
  }
  SECTION("beyond them: 3 s and 2 s after the last word") {
    s.say(node(StationId{1}), 15.1, state);
    s.say(scheduler_node(), 20, finished(4, 0));
    CHECK(broken_laws(facts(), s) == Laws{"L10"});
  }
  SECTION("half a tank of 10 l was granted once") {
    state.filled = litres(10);
    s.say(node(StationId{1}), 11, state);
    s.say(scheduler_node(), 20, finished(4, 0));
    CHECK(broken_laws(facts(), s) == Laws{"L12"});
  }
}

TEST_CASE("laws: L17 a gap or a step back in the log", "[sim]") {
  Script gap = clean_run();
  gap.seq[scheduler_node()] = 7;
  gap.say(scheduler_node(), 6, finished(4, 0));
  CHECK(broken_laws(facts(), gap) == Laws{"L17"});

  Script back = clean_run();
  back.say(scheduler_node(), 4, finished(4, 0));
  CHECK(broken_laws(facts(), back) == Laws{"L17"});
}

AgentState heard(Phase phase, double battery, FieldPoint position) {
  AgentState state{};
  state.agent = one;
  state.phase = phase;
  state.tank = 0.97;  // 8 m of 300 m are sprayed
  state.battery = battery;
  state.position = position;
  return state;
}

TEST_CASE("laws: L5 the valve open inside a hole or an obstacle", "[sim]") {
  Facts f = facts();
  f.field = {.boundary = {at_m(0, 0), at_m(30, 0), at_m(30, 30), at_m(0, 30)},
             .holes = {{at_m(5, 5), at_m(15, 5), at_m(15, 15), at_m(5, 15)}},
             .obstacles = {{"oak", at_m(20, 20), metres(1.5)}}};
  Script s = clean_run();
  FlightRecord stray = flight({0, 0});
  // Half a swath is 1 m: as far in is the boom's edge.
  SECTION("at their edges") {
    stray.track = {
        {at(4), at_m(5.9, 10), true}, {at(5), at_m(20.6, 20), true}, {at(6), at_m(10, 10), false}};
    s.say(node(one), 6.5, stray);
    s.say(scheduler_node(), 7, finished(4, 0));
    CHECK(broken_laws(f, s) == Laws{});
  }
  SECTION("deeper") {
    stray.track = {{at(4), at_m(6.1, 10), true}, {at(5), at_m(20.4, 20), true}};
    s.say(node(one), 6.5, stray);
    s.say(scheduler_node(), 7, finished(4, 0));
    const auto all = violations(f, s.log, at(100));
    REQUIRE(all.size() == 2);
    CHECK(all[0].detail == "agent 1 sprayed at (6.1, 10.0) m, more than 1.00 m inside a hole");
    CHECK(all[1].detail ==
          "agent 1 sprayed at (20.4, 20.0) m, more than 1.00 m inside obstacle oak");
  }
}

TEST_CASE("laws: L5 the valve open in another phase than spray", "[sim]") {
  for (const Phase phase : {Phase::spray, Phase::hold, Phase::fly_back, Phase::fly_out}) {
    Script s = clean_run();
    s.say(node(one), 6, heard(phase, 0.9, at_m(1, 5)));
    FlightRecord record = flight({0, 0});
    record.track = {{at(6), at_m(1, 5), true}};
    s.say(node(one), 6.5, record);
    s.say(scheduler_node(), 7, finished(4, 0));
    CHECK(broken_laws(facts(), s) == (phase == Phase::spray ? Laws{} : Laws{"L5"}));
  }
}

TEST_CASE("laws: L6 cells that are none of the field, granted and closed", "[sim]") {
  Script s = clean_run();
  s.say(scheduler_node(), 6, grant(2, {4, 2}));
  s.say(node(one), 6.5, closure(2, {4, 2}, 2));
  s.say(scheduler_node(), 7, finished(4, 0));
  CHECK(broken_laws(facts(), s) == Laws{"L6"});
}

TEST_CASE("laws: L7 the way home is flown against the mean wind", "[sim]") {
  // 24 m/s through the air against 20 m/s leave 4 m/s: 60 m take 15 s, 0.015 of a pack.
  Facts f = facts();
  f.wind = {.mean = metres_per_second(20), .from_deg = 180, .gust = {}};
  const auto broken = [&](double battery) {
    Script s = clean_run();
    s.say(node(one), 6, heard(Phase::spray, battery, at_m(0, 60)));
    s.say(scheduler_node(), 7, finished(4, 0));
    return broken_laws(f, s);
  };
  CHECK(broken(0.1151) == Laws{});
  CHECK(broken(0.1149) == Laws{"L7"});
  f.wind.from_deg = 0;  // from behind: 10 s at ferry speed
  CHECK(broken(0.1101) == Laws{});
  f.wind = {.mean = metres_per_second(25), .from_deg = 180, .gust = {}};  // no way home
  CHECK(broken(1.0) == Laws{"L7"});
}

TEST_CASE("laws: L7 a take-off with too little to get out and home", "[sim]") {
  // 120 m out and home at 6 m/s are 40 s, 0.04 of a pack, and 0.1 of reserve.
  for (const double battery : {0.139, 0.141}) {
    Script s = clean_run();
    s.say(node(one), 6, heard(Phase::fly_out, battery, at_m(0, 0)));
    SortieReport sortie{};
    sortie.agent = one;
    sortie.resumed_at = at_m(0, 120);
    sortie.began = at(5.5);
    sortie.landed = at(60);
    sortie.sprayed = metres(8);
    s.say(node(one), 61, heard(Phase::done, battery, at_m(0, 0)));
    s.log.back().body = [&] {
      AgentState landed = heard(Phase::done, battery, at_m(0, 0));
      landed.tank = 1.0 - 8.0 / 300.0;
      return landed;
    }();
    s.say(node(one), 62, sortie);
    s.say(scheduler_node(), 63, finished(4, 0));
    CHECK(broken_laws(facts(), s) == (battery < 0.14 ? Laws{"L7"} : Laws{}));
  }
}

TEST_CASE("laws: L8 the mix of an aircraft that was last heard in the air", "[sim]") {
  // 8 m of cells are flown since take-off: 292 m are left. Allowed are 0.3 m, 2 % and 2.5 cells of
  // 2 m, and 1.1 s at 3 m/s: 8.76 m more or less.
  const auto broken = [](double left_m, bool has_window) {
    Script s = clean_run();
    if (has_window) s.say(scheduler_node(), 5.5, grant(2, {0, 0}));
    AgentState state = heard(Phase::spray, 0.9, at_m(1, 5));
    state.tank = left_m / 300.0;
    s.say(node(one), 6, state);
    s.say(scheduler_node(), 7, finished(4, 0));
    return broken_laws(facts(), s);
  };
  CHECK(broken(292.0, false) == Laws{});
  CHECK(broken(283.4, false) == Laws{});
  CHECK(broken(283.1, false) == Laws{"L8"});
  CHECK(broken(150.0, true) == Laws{"L8"});
}

TEST_CASE("laws: L8 windows under way may have been sprayed without a record yet", "[sim]") {
  // Nothing is recorded of four cells granted: up to 8 m, and 0.3 m, 4 m and 3.3 m besides.
  for (const double left_m : {284.5, 284.3}) {
    Script s;
    s.say(scheduler_node(), 1, grant(1, {0, 4}));
    AgentState state = heard(Phase::spray, 0.9, at_m(1, 5));
    state.tank = left_m / 300.0;
    s.say(node(one), 6, state);
    Facts f = facts();
    f.whole = false;
    CHECK(broken_laws(f, s) == (left_m < 284.4 ? Laws{"L8"} : Laws{}));
  }
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
  CHECK(broken_at(1.3).empty());  // no plan to keep clear
  f.plan.sweep.emplace();
  f.plan.sweep->avoidance.emplace().safety = metres(1);
  CHECK(broken_at(1.41).empty());
  CHECK(broken_at(1.39) == std::vector<std::string>{"L22"});
  f.plan.uavs[0].vehicle.gnss.bias = metres(0.5);
  CHECK(broken_at(1.0).empty());
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
          StationState{.station = StationId{9}, .bays = {}, .queue = {}, .swaps = 0, .filled = {}});
  }
  s.say(scheduler_node(), 7, finished(4, 0));
  CHECK(broken_laws(facts(), s) == Laws{"L21"});
}

}  // namespace
}  // namespace furrow::sim
