#include "tests/sim/checkers/scripted_log.hpp"

#include <catch2/catch.hpp>

namespace furrow::sim {
namespace {

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

}  // namespace
}  // namespace furrow::sim
