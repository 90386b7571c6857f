#include "supply/queue.hpp"

#include <catch2/catch.hpp>

namespace furrow::supply {
namespace {

using std::chrono::seconds;

constexpr Instant at_s(int s) { return Instant{seconds{s}}; }
constexpr LeaseTerms terms{.lease = seconds{3}, .clearing = seconds{2}};

Station station(std::uint32_t bays) {
  return {.id = StationId{1},
          .position = at_m(0, 0),
          .bays = bays,
          .battery_swap = furrow::seconds(60.0),
          .fill_base = furrow::seconds(20.0),
          .fill_full = furrow::seconds(60.0)};
}

ServiceClaim claim(std::uint32_t agent, int first_claimed_s, std::uint64_t number = 1) {
  return {.agent = AgentId{agent},
          .boot = BootId{agent},
          .station = StationId{1},
          .claim = number,
          .first_claimed = at_s(first_claimed_s),
          .status = ClaimStatus::waiting,
          .token = 0,
          .swap = false,
          .fill = 0.5};
}

ServiceClaim with(ServiceClaim c, ClaimStatus status, std::uint64_t token = 0) {
  c.status = status;
  c.token = token;
  return c;
}

TEST_CASE("queue: serves by first claim, then by agent id, whatever order the claims arrive in",
          "[supply]") {
  BayQueue queue{station(1), terms};
  for (const auto& c : {claim(3, 1), claim(2, 0), claim(1, 1)}) queue.hear(c, at_s(1));

  const auto first = queue.advance(at_s(1));
  REQUIRE(first.size() == 1);
  CHECK(first[0].agent == AgentId{2});
  CHECK(first[0].bay == 1);
  CHECK(first[0].token == 1);
  // Half a tank, no swap: 20 + 0.5 * (60 - 20) = 40 s.
  CHECK(first[0].ready == at_s(41));
  CHECK(queue.waiting()[0].agent == AgentId{1});
  CHECK(queue.waiting()[1].agent == AgentId{3});

  queue.hear(with(claim(2, 0), ClaimStatus::released, 1), at_s(2));
  const auto second = queue.advance(at_s(2));
  REQUIRE(second.size() == 1);
  CHECK(second[0].agent == AgentId{1});
  CHECK(second[0].token == 2);
}

TEST_CASE("queue: says when one who comes now is expected to have a bay", "[supply]") {
  BayQueue queue{station(2), terms};
  CHECK(queue.next_free(at_s(1)) == at_s(1));
  for (const std::uint32_t agent : {1u, 2u, 3u}) queue.hear(claim(agent, 1), at_s(1));
  queue.advance(at_s(1));
  // Half a tank takes 40 s: both bays are free at 41 s, the first then serves the third to 81 s.
  CHECK(queue.next_free(at_s(1)) == at_s(41));
  queue.shut(2);
  CHECK(queue.next_free(at_s(1)) == at_s(81));
  CHECK(queue.next_free(at_s(50)) == at_s(90));
  queue.shut(1);
  CHECK(queue.next_free(at_s(50)) == Instant{});
}

TEST_CASE("queue: a claim that waits unrenewed is dropped when its lease ends", "[supply]") {
  BayQueue queue{station(1), terms};
  queue.hear(claim(1, 0), at_s(0));
  queue.hear(claim(2, 0), at_s(0));
  queue.advance(at_s(0));
  queue.hear(with(claim(1, 0), ClaimStatus::in_bay, 1), at_s(2));
  queue.advance(at_s(2));
  CHECK(queue.waiting().size() == 1);
  CHECK(queue.next_event() == at_s(3));
  queue.advance(at_s(3));
  CHECK(queue.waiting().empty());
  CHECK(queue.in_bay().size() == 1);
}

TEST_CASE("queue: a silent holder's bay goes on at lease plus clearing, and no earlier",
          "[supply]") {
  BayQueue queue{station(1), terms};
  queue.hear(claim(1, 0), at_s(0));
  queue.advance(at_s(0));
  for (int s = 1; s <= 4; ++s) {
    queue.hear(claim(2, 1), at_s(s));
    CHECK(queue.advance(at_s(s)).empty());
  }
  queue.hear(claim(2, 1), at_s(5));  // 3 s lease + 2 s clearing
  const auto served = queue.advance(at_s(5));
  REQUIRE(served.size() == 1);
  CHECK(served[0].agent == AgentId{2});
  CHECK(served[0].token == 2);
  CHECK(queue.handed_out().tanks.empty());  // the first was never served to its end
}

TEST_CASE("queue: a holder heard again has its bay back while nobody else has it", "[supply]") {
  BayQueue queue{station(1), terms};
  queue.hear(claim(1, 0), at_s(0));
  queue.advance(at_s(0));
  queue.advance(at_s(5));
  CHECK(queue.in_bay().empty());
  const auto back = queue.hear(with(claim(1, 0), ClaimStatus::in_bay, 1), at_s(7));
  REQUIRE(back);
  CHECK(back->token == 1);
  CHECK(back->ready == at_s(40));
  CHECK(queue.advance(at_s(7)).empty());
}

TEST_CASE("queue: a holder heard again queues in its old place when its bay is another's",
          "[supply]") {
  BayQueue queue{station(1), terms};
  queue.hear(claim(1, 0), at_s(0));
  queue.advance(at_s(0));
  queue.hear(claim(2, 4), at_s(5));
  CHECK(queue.advance(at_s(5)).size() == 1);
  queue.hear(claim(3, 5), at_s(6));
  const auto back = queue.hear(with(claim(1, 0), ClaimStatus::in_bay, 1), at_s(7));
  REQUIRE(back);
  CHECK(back->bay == 0);
  CHECK(queue.waiting()[0].agent == AgentId{1});
}

TEST_CASE("queue: a service that ended in silence counts when its holder is heard again",
          "[supply]") {
  BayQueue queue{station(1), terms};
  queue.hear(claim(1, 0), at_s(0));
  queue.advance(at_s(0));
  queue.advance(at_s(5));
  queue.hear(with(claim(1, 0), ClaimStatus::released, 1), at_s(45));
  queue.hear(with(claim(1, 0), ClaimStatus::released, 1), at_s(46));
  queue.advance(at_s(46));
  CHECK(queue.handed_out().tanks.at(AgentId{1}) == 0.5);
}

TEST_CASE("queue: late, repeated and reordered claims of a finished visit change nothing",
          "[supply]") {
  BayQueue queue{station(1), terms};
  queue.hear(claim(1, 0), at_s(0));
  queue.advance(at_s(0));
  queue.hear(with(claim(1, 0), ClaimStatus::released, 1), at_s(1));
  const auto changes = queue.changes();
  CHECK_FALSE(queue.hear(claim(1, 0), at_s(1)));
  CHECK_FALSE(queue.hear(with(claim(1, 0), ClaimStatus::in_bay, 1), at_s(1)));
  CHECK_FALSE(queue.hear(with(claim(1, 0), ClaimStatus::released, 1), at_s(1)));
  CHECK(queue.advance(at_s(1)).empty());
  CHECK(queue.in_bay().empty());
  CHECK(queue.changes() == changes);
}

TEST_CASE("queue: a stale waiting claim after the bay was given renews the same token",
          "[supply]") {
  BayQueue queue{station(2), terms};
  queue.hear(claim(1, 0), at_s(0));
  queue.advance(at_s(0));
  const auto again = queue.hear(claim(1, 0), at_s(1));
  REQUIRE(again);
  CHECK(again->bay == 1);
  CHECK(again->token == 1);
  CHECK(queue.advance(at_s(1)).empty());
}

TEST_CASE("queue: a newer visit ends an older one whose release was lost", "[supply]") {
  BayQueue queue{station(1), terms};
  queue.hear(claim(1, 0, 1), at_s(0));
  queue.advance(at_s(0));
  const auto fresh = queue.hear(claim(1, 1, 2), at_s(1));
  REQUIRE(fresh);
  CHECK(fresh->bay == 0);
  const auto served = queue.advance(at_s(1));
  REQUIRE(served.size() == 1);
  CHECK(served[0].claim == 2);
  CHECK(served[0].token == 2);
  CHECK_FALSE(queue.hear(claim(1, 0, 1), at_s(1)));
}

TEST_CASE("queue: a restarted agent is served anew once its bay is cleared; its past is ignored",
          "[supply]") {
  BayQueue queue{station(1), terms};
  queue.hear(claim(1, 0, 7), at_s(0));
  queue.advance(at_s(0));
  ServiceClaim reborn = claim(1, 1, 1);
  reborn.boot = BootId{99};
  CHECK_FALSE(queue.hear(reborn, at_s(1)));
  queue.advance(at_s(5));
  REQUIRE(queue.hear(reborn, at_s(5)));
  CHECK_FALSE(queue.hear(claim(1, 0, 7), at_s(5)));
  CHECK(queue.advance(at_s(5)).size() == 1);
}

TEST_CASE("queue: every service counts once, when it is done", "[supply]") {
  BayQueue queue{station(1), terms};
  ServiceClaim c = claim(1, 0);
  c.swap = true;
  queue.hear(c, at_s(0));
  queue.advance(at_s(0));
  for (int s = 1; s < 60; ++s) queue.hear(with(c, ClaimStatus::in_bay, 1), at_s(s));
  queue.advance(at_s(59));
  CHECK(queue.handed_out().swaps == 0);
  CHECK(queue.next_event() == at_s(60));  // max(60, 40) s
  queue.advance(at_s(60));
  queue.hear(with(c, ClaimStatus::released, 1), at_s(61));
  queue.hear(with(c, ClaimStatus::released, 1), at_s(62));
  queue.advance(at_s(62));
  CHECK(queue.handed_out().swaps == 1);
  CHECK(queue.handed_out().tanks.at(AgentId{1}) == 0.5);
}

TEST_CASE("queue: claims for another station or out of range are refused", "[supply]") {
  BayQueue queue{station(1), terms};
  ServiceClaim elsewhere = claim(1, 0);
  elsewhere.station = StationId{2};
  ServiceClaim flood = claim(1, 0);
  flood.fill = 1.5;
  CHECK_FALSE(queue.hear(elsewhere, at_s(0)));
  CHECK_FALSE(queue.hear(flood, at_s(0)));
  CHECK(queue.advance(at_s(0)).empty());
}

TEST_CASE("queue: the last of the mix goes to who is next, and after that it is lacking",
          "[supply]") {
  Station short_of_mix = station(1);
  short_of_mix.mix = litres(8.0);
  std::map<AgentId, Volume> tanks;
  for (std::uint32_t i = 1; i <= 3; ++i) tanks[AgentId{i}] = litres(10.0);
  BayQueue queue{short_of_mix, terms, tanks};
  for (const auto& c : {claim(1, 0), claim(2, 1), claim(3, 2)}) queue.hear(c, at_s(2));

  const auto first = queue.advance(at_s(2));
  REQUIRE(first.size() == 1);
  CHECK(first[0].gives_fill == 0.5);
  CHECK(queue.filled() == litres(0.0));  // not before it is done
  CHECK_FALSE(queue.lacks(queue.waiting()[0], at_s(2)));
  queue.hear(with(claim(1, 0), ClaimStatus::in_bay, 1), at_s(42));
  for (const auto& c : {claim(2, 1), claim(3, 2)}) queue.hear(c, at_s(42));
  queue.hear(with(claim(1, 0), ClaimStatus::released, 1), at_s(42));

  // 5 l of 8 are gone: 3 l are 0.3 of a tank, 20 + 0.3 * (60 - 20) = 32 s.
  const auto second = queue.advance(at_s(42));
  REQUIRE(second.size() == 1);
  CHECK(second[0].agent == AgentId{2});
  CHECK(second[0].gives_fill == Approx(0.3));
  CHECK(second[0].ready == at_s(74));
  REQUIRE(queue.waiting().size() == 1);
  CHECK(queue.lacks(queue.waiting()[0], at_s(42)));

  // Who leaves before it is filled leaves the mix to the others.
  queue.hear(with(claim(2, 1), ClaimStatus::released, 2), at_s(43));
  CHECK_FALSE(queue.lacks(queue.waiting()[0], at_s(43)));
}

TEST_CASE("queue: without packs those who want mix as well are given mix, the others nothing",
          "[supply]") {
  Station no_packs = station(1);
  no_packs.packs = 0;
  BayQueue queue{no_packs, terms};
  ServiceClaim both = claim(1, 1), pack_alone = claim(2, 0);
  both.swap = pack_alone.swap = true;
  pack_alone.fill = 0.0;
  queue.hear(pack_alone, at_s(1));
  queue.hear(both, at_s(1));
  const auto served = queue.advance(at_s(1));
  REQUIRE(served.size() == 1);
  CHECK(served[0].agent == AgentId{1});
  CHECK_FALSE(served[0].gives_swap);
  CHECK(served[0].gives_fill == 0.5);
  CHECK(queue.lacks(queue.waiting()[0], at_s(1)));
}

TEST_CASE("queue: a bay that is shut is given to nobody more, and without bays all is lacking",
          "[supply]") {
  BayQueue queue{station(2), terms};
  queue.hear(claim(1, 0), at_s(0));
  CHECK(queue.advance(at_s(0)).at(0).bay == 1);
  queue.shut(1);
  queue.hear(claim(2, 1), at_s(1));
  queue.hear(claim(3, 1), at_s(1));
  CHECK(queue.advance(at_s(1)).at(0).bay == 2);
  CHECK(queue.in_bay().size() == 2);  // who is in it stays
  CHECK_FALSE(queue.lacks(queue.waiting().at(0), at_s(1)));
  queue.hear(with(claim(1, 0), ClaimStatus::released, 1), at_s(2));
  CHECK(queue.advance(at_s(2)).empty());
  queue.shut(2);
  CHECK(queue.open_bays() == 0);
  CHECK(queue.lacks(queue.waiting().at(0), at_s(2)));
}

TEST_CASE(
    "queue: nobody is served before the station opens, and who would be served beyond its end "
    "is lacking",
    "[supply]") {
  Station hours = station(1);
  hours.available_from = furrow::seconds(10.0);
  hours.available_until = furrow::seconds(100.0);
  BayQueue queue{hours, {.lease = seconds{100}}};
  for (const auto& c : {claim(1, 0), claim(2, 1)}) queue.hear(c, at_s(1));
  CHECK(queue.advance(at_s(1)).empty());
  CHECK(queue.next_event() == at_s(10));
  CHECK_FALSE(queue.lacks(queue.waiting()[0], at_s(1)));
  // Both wait for 40 s of mix each: the bay is free at 10 + 40 + 40.
  CHECK(queue.next_free(at_s(1)) == at_s(90));

  REQUIRE(queue.advance(at_s(10)).size() == 1);
  // The second takes 40 s too: it begins at 60 s at the latest.
  CHECK_FALSE(queue.lacks(queue.waiting()[0], at_s(60)));
  CHECK(queue.lacks(queue.waiting()[0], at_s(61)));
  queue.advance(at_s(50));
  queue.hear(with(claim(1, 0), ClaimStatus::in_bay, 1), at_s(50));
  CHECK(queue.next_event() == at_s(60) + Duration{1});
  queue.hear(with(claim(1, 0), ClaimStatus::released, 1), at_s(61));
  CHECK(queue.advance(at_s(61)).empty());
}

TEST_CASE("queue: a service may end as the station closes", "[supply]") {
  Station hours = station(1);
  hours.available_until = furrow::seconds(41.0);
  BayQueue queue{hours, terms};
  queue.hear(claim(1, 0), at_s(1));
  CHECK(queue.advance(at_s(1)).size() == 1);  // half a tank takes 40 s
}

}  // namespace
}  // namespace furrow::supply
