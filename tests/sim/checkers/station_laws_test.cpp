#include "tests/sim/checkers/scripted_log.hpp"

#include <catch2/catch.hpp>

namespace furrow::sim {
namespace {

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
  SECTION("two are given bays at once, before the first says that it is in") {
    s.say(node(one), 12, claim(one, ClaimStatus::released, 1, 10));
    ServiceClaim again = claim(one, ClaimStatus::waiting, 0, 12.2);
    again.claim = 2;
    s.say(node(two), 12.1, claim(two, ClaimStatus::waiting, 0, 11));
    s.say(node(one), 12.2, again);
    s.say(node(StationId{1}), 14, bay_one(two, 2, 14));
    ServiceGrant beside = bay_one(one, 3, 14.04);
    beside.claim = 2;
    beside.bay = 2;
    s.say(node(StationId{1}), 14.04, beside);
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
      .filled = litres(5),
      .open_bays = 1};
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
  SECTION("its mix and packs just suffice") {
    Facts sufficient = facts();
    sufficient.stations[0].mix = litres(5);
    sufficient.stations[0].packs = 1;
    s.say(scheduler_node(), 20, finished(4, 0));
    CHECK(broken_laws(sufficient, s) == Laws{});
  }
  SECTION("it gave more mix than it had") {
    Facts empty = facts();
    empty.stations[0].mix = litres(4.9);
    s.say(scheduler_node(), 20, finished(4, 0));
    CHECK(broken_laws(empty, s) == Laws{"L12"});
  }
  SECTION("it gave more packs than it had") {
    Facts empty = facts();
    empty.stations[0].packs = 0;
    s.say(scheduler_node(), 20, finished(4, 0));
    CHECK(broken_laws(empty, s) == Laws{"L12"});
  }
  SECTION("half a tank of 10 l was granted once") {
    state.filled = litres(10);
    s.say(node(StationId{1}), 11, state);
    s.say(scheduler_node(), 20, finished(4, 0));
    CHECK(broken_laws(facts(), s) == Laws{"L12"});
  }
}

TEST_CASE("laws: L27 a bay given before its station opens or for longer than it is open", "[sim]") {
  // The service takes from 10.1 to 70.1 s.
  const auto broken_within = [](double from_s, double until_s) {
    Facts f = facts();
    f.stations[0].available_from = seconds(from_s);
    f.stations[0].available_until = seconds(until_s);
    Script s = clean_run();
    s.say(node(one), 10, claim(one, ClaimStatus::waiting, 0, 10));
    s.say(node(StationId{1}), 10.1, bay_one(one, 1, 10.1));
    s.say(scheduler_node(), 20, finished(4, 0));
    return broken_laws(f, s);
  };
  CHECK(broken_within(10.1, 70.1) == Laws{});
  CHECK(broken_within(10.2, 80) == Laws{"L27"});
  CHECK(broken_within(0, 70) == Laws{"L27"});
}

}  // namespace
}  // namespace furrow::sim
