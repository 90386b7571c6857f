#include "supply/supply_node.hpp"

#include "core/node_host.hpp"

#include <catch2/catch.hpp>

#include <memory>

namespace furrow::supply {
namespace {

using std::chrono::seconds;

constexpr Instant at_s(int s) { return Instant{seconds{s}}; }

SupplySettings settings(std::uint32_t bays, seconds lease = seconds{3}) {
  SupplySettings s{.station = {.id = StationId{1},
                               .position = at_m(0, 0),
                               .bays = bays,
                               .battery_swap = furrow::seconds(60.0),
                               .fill_base = furrow::seconds(20.0),
                               .fill_full = furrow::seconds(60.0)},
                   .tanks = {},
                   .terms = {.lease = lease, .clearing = seconds{1}}};
  for (std::uint32_t i = 1; i <= 9; ++i) s.tanks[AgentId{i}] = litres(10.0);
  return s;
}

struct Service {
  AgentId agent;
  ServiceGrant grant;
};

// Claims a bay, is served, releases; `visits` times over.
struct Customer {
  AgentId id;
  int visits;
  std::vector<Service>* served;
  std::uint64_t claim = 1;
  Instant first_claimed{};
  std::optional<ServiceGrant> held{};

  Outbox step(const Inbox& inbox, Instant now) {
    for (const Envelope& e : inbox) {
      const auto* grant = std::get_if<ServiceGrant>(&e.body);
      if (grant != nullptr && grant->claim == claim) held = *grant;
    }
    if (visits == 0) return {};
    ServiceClaim said{.agent = id,
                      .boot = BootId{1},
                      .station = StationId{1},
                      .claim = claim,
                      .first_claimed = first_claimed,
                      .status = held ? ClaimStatus::in_bay : ClaimStatus::waiting,
                      .token = held ? held->token : 0,
                      .swap = true,
                      .fill = 0.25};
    if (held && now >= held->ready) {
      served->push_back({id, *held});
      said.status = ClaimStatus::released;
      ++claim;
      first_claimed = now;
      held.reset();
      --visits;
    }
    Instant wake = now + seconds{1};
    if (held && held->ready > now) wake = std::min(wake, held->ready);
    return {.messages = {said}, .wake = wake};
  }
};

struct Recorded {
  std::vector<Service> served;
  std::vector<StationState> states;
  std::vector<Instant> stated_at;
};

Recorded fly(const Link& radio, std::uint32_t bays, int customers, seconds lease) {
  Recorded r;
  NodeHost host{radio, 5};
  host.add(node(StationId{1}), AnyNode{SupplyNode{settings(bays, lease)}}, Instant{});
  for (int i = 1; i <= customers; ++i) {
    const AgentId id{static_cast<std::uint32_t>(i)};
    host.add(node(id), AnyNode{Customer{id, 3, &r.served}}, Instant{});
  }
  while (host.next_event() < at_s(3600)) {
    for (const Envelope& e : host.advance(host.next_event() + radio.latency)) {
      host.deliver(e);
      if (const auto* state = std::get_if<StationState>(&e.body)) {
        r.states.push_back(*state);
        r.stated_at.push_back(e.sent);
      }
    }
  }
  return r;
}

TEST_CASE("supply_node: over a lossy radio every visit is served once and no bay twice at a time",
          "[supply]") {
  const Link radio{.latency = Duration{20'000'000},
                   .jitter = Duration{400'000'000},
                   .loss = 0.2,
                   .duplication = 0.2};
  const Recorded r = fly(radio, 2, 5, seconds{15});

  REQUIRE(r.served.size() == 15);
  for (std::size_t i = 0; i < r.served.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const ServiceGrant &a = r.served[i].grant, &b = r.served[j].grant;
      CHECK(a.token != b.token);
      if (a.bay == b.bay) CHECK((a.ready <= b.starts || b.ready <= a.starts));
    }
  }
  // 15 swaps; a quarter of a 10 l tank each: 37.5 l.
  CHECK(r.states.back().swaps == 15);
  CHECK(r.states.back().filled.base() == Approx(37.5));
}

TEST_CASE("supply_node: says its state at whole seconds, when it changed or every five seconds",
          "[supply]") {
  const Link radio{.latency = Duration{20'000'000}, .jitter = {}, .loss = 0, .duplication = 0};
  const Recorded r = fly(radio, 1, 1, seconds{3});
  REQUIRE(!r.states.empty());
  CHECK(r.stated_at[0] == at_s(0));
  for (std::size_t i = 0; i < r.stated_at.size(); ++i) {
    CHECK(r.stated_at[i].time_since_epoch() % seconds{1} == Duration::zero());
    if (i > 0) CHECK(r.stated_at[i] - r.stated_at[i - 1] <= seconds{5});
  }
  // A quiet hour is one state in 5 s; three services add a few seconds with a change each.
  CHECK(r.states.size() < 3600 / 5 + 15);
}

TEST_CASE("supply_node: who claims what there is no more of is told so", "[supply]") {
  SupplySettings empty = settings(1);
  empty.station.mix = litres(0.0);
  empty.station.packs = 0;
  SupplyNode station{empty};
  station.step({}, at_s(0));
  const Envelope claim{.from = node(AgentId{4}),
                       .seq = 1,
                       .sent = at_s(1),
                       .body = ServiceClaim{.agent = AgentId{4},
                                            .boot = BootId{1},
                                            .station = StationId{1},
                                            .claim = 7,
                                            .first_claimed = at_s(1),
                                            .status = ClaimStatus::waiting,
                                            .token = 0,
                                            .swap = true,
                                            .fill = 1.0}};
  const Outbox out = station.step({claim}, at_s(1));
  const auto* refusal = std::get_if<ServiceGrant>(&out.messages.at(0));
  REQUIRE(refusal != nullptr);
  CHECK(refusal->agent == AgentId{4});
  CHECK(refusal->claim == 7);
  CHECK(refusal->bay == 0);
  CHECK(refusal->token == 0);
  CHECK_FALSE(refusal->swap);
  CHECK(refusal->fill == 0.0);
}

}  // namespace
}  // namespace furrow::supply
