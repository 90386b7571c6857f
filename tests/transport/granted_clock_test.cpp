#include "transport/granted_clock.hpp"

#include <catch2/catch.hpp>

namespace furrow {
namespace {

using transport::GrantedClock;

constexpr Duration latency{50};
constexpr Instant at(std::int64_t ns) { return Instant{Duration{ns}}; }

// The scheduler is participant 1, agents 1 and 2 are participants 2 and 3.
GrantedClock three_members() {
  return GrantedClock{{{1, {scheduler_node()}}, {2, {node(AgentId{1})}}, {3, {node(AgentId{2})}}},
                      latency};
}

TEST_CASE("granted_clock: those with events within one latency of the first go side by side",
          "[transport]") {
  GrantedClock clock = three_members();
  CHECK_FALSE(clock.is_round_done());
  clock.report(1, at(100));
  clock.report(2, at(149));
  clock.report(3, at(150));
  REQUIRE(clock.is_round_done());

  // T = 100, limit = 100 + 50: the event at 149 is in, that at 150 is not.
  const auto round = clock.next_round(never);
  CHECK(round.limit == at(150));
  REQUIRE(round.grants.size() == 2);
  CHECK(round.grants[0].participant == 1);
  CHECK(round.grants[1].participant == 2);
}

TEST_CASE("granted_clock: a message wakes those it concerns, who must hold it first",
          "[transport]") {
  GrantedClock clock = three_members();
  clock.report(1, at(0));
  clock.report(2, never);
  clock.report(3, never);
  REQUIRE(clock.next_round(never).grants.size() == 1);

  Command command{};
  command.agent = AgentId{2};
  clock.sent(1, 2, 17, {scheduler_node(), 5, at(10), command});
  clock.report(1, never);

  // Sent at 10, it arrives at 60 or later; only agent 2 acts on it.
  CHECK(clock.next_event() == at(60));
  const auto round = clock.next_round(never);
  REQUIRE(round.grants.size() == 1);
  CHECK(round.grants[0].participant == 3);
  CHECK(round.grants[0].needed.at({1, 2}) == 17);

  clock.report(3, never);
  CHECK(clock.next_event() == never);
}

TEST_CASE("granted_clock: waits for no dead member", "[transport]") {
  GrantedClock clock = three_members();
  clock.report(1, at(0));
  clock.report(2, at(0));
  CHECK_FALSE(clock.is_round_done());
  clock.drop(3);
  CHECK(clock.is_round_done());
}

TEST_CASE("granted_clock: grants nothing beyond the last limit", "[transport]") {
  GrantedClock clock = three_members();
  for (const std::uint32_t p : {1u, 2u, 3u}) clock.report(p, at(0));
  CHECK(clock.next_round(at(20)).limit == at(20));
}

}  // namespace
}  // namespace furrow
