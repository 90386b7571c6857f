#include "tests/sim/checkers/scripted_log.hpp"

#include <catch2/catch.hpp>

namespace furrow::sim {
namespace {

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

TEST_CASE("laws: L7 home is the station that the order says, and where a refused one went",
          "[sim]") {
  // A station 30 m north: 30 m less from (0, 60) than from the first, 0.005 of a pack.
  Facts f = facts();
  f.stations.push_back(f.stations.front());
  f.stations.back().id = StationId{2};
  f.stations.back().position = at_m(0, 30);
  const auto broken = [&](double battery, bool ordered, bool claimed) {
    Script s = clean_run();
    if (ordered)
      s.say(scheduler_node(), 5.1,
            Command{.agent = one,
                    .target_boot = BootId{},
                    .epoch = Epoch{1},
                    .revision = 2,
                    .sorties = {{.pieces = {}, .station = StationId{2}}},
                    .obstacles = {}});
    if (claimed) {
      ServiceClaim claim{};
      claim.agent = one;
      claim.station = StationId{2};
      s.say(node(one), 5.2, claim);
    }
    s.say(node(one), 5.4, heard(Phase::wait, 1.0, at_m(0, 0)));
    s.say(node(one), 6, heard(Phase::spray, battery, at_m(0, 60)));
    s.say(scheduler_node(), 7, finished(4, 0));
    const Laws all = broken_laws(f, s);
    return std::count(all.begin(), all.end(), "L7");
  };
  CHECK(broken(0.1051, false, false) == 1);
  CHECK(broken(0.1051, true, false) == 0);
  CHECK(broken(0.1049, true, false) == 1);
  CHECK(broken(0.1051, false, true) == 0);
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

}  // namespace
}  // namespace furrow::sim
