#include "core/node_host.hpp"

#include <catch2/catch.hpp>

namespace furrow {
namespace {

constexpr Link quiet_radio{
    .latency = Duration{50'000'000}, .jitter = {}, .loss = 0, .duplication = 0};
constexpr Instant epoch{};
constexpr Duration second{1'000'000'000};

// Says its name once a second for three seconds.
struct Talker {
  Instant last{};
  Outbox step(const Inbox&, Instant now) {
    const bool go_on = now < epoch + 3 * second;
    return {.messages = {Event{"talk", ""}, SchedulerState{}},
            .wake = go_on ? now + second : never};
  }
};

// Keeps when it heard whom.
struct Listener {
  std::vector<std::pair<Instant, std::uint64_t>>* heard;
  Outbox step(const Inbox& inbox, Instant now) {
    for (const auto& e : inbox) heard->push_back({now, e.seq});
    return {};
  }
};

TEST_CASE("node_host: a message arrives one latency after it was sent, to those it concerns",
          "[core]") {
  std::vector<std::pair<Instant, std::uint64_t>> heard;
  NodeHost host{quiet_radio, 1};
  host.add(scheduler_node(), AnyNode{Talker{}}, epoch);
  host.add(node(AgentId{7}), AnyNode{Listener{&heard}}, epoch);

  std::vector<Envelope> log;
  while (host.next_event() < never) {
    const auto sent = host.advance(host.next_event() + quiet_radio.latency);
    for (const auto& e : sent) host.deliver(e);
    log.insert(log.end(), sent.begin(), sent.end());
  }

  // Four steps (0, 1, 2, 3 s) of two messages; an agent acts on the second of each only.
  REQUIRE(log.size() == 8);
  REQUIRE(heard.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(heard[i].first == epoch + static_cast<int>(i) * second + quiet_radio.latency);
    CHECK(heard[i].second == 2 * (i + 1));
  }
}

TEST_CASE("node_host: a node that starts late has not heard what was said before", "[core]") {
  std::vector<std::pair<Instant, std::uint64_t>> heard;
  NodeHost host{quiet_radio, 1};
  host.add(scheduler_node(), AnyNode{Talker{}}, epoch);
  host.add(node(AgentId{7}), AnyNode{Listener{&heard}}, epoch + 2 * second);
  while (host.next_event() < never) {
    for (const auto& e : host.advance(host.next_event() + quiet_radio.latency)) host.deliver(e);
  }
  // Of the states said at 0, 1, 2 and 3 s, those of the last two.
  REQUIRE(heard.size() == 2);
  CHECK(heard[0].first == epoch + 2 * second + quiet_radio.latency);
}

TEST_CASE("node_host: a node that dies says nothing from that instant on", "[core]") {
  NodeHost host{quiet_radio, 1};
  host.add(scheduler_node(), AnyNode{Talker{}}, epoch, epoch + 2 * second);

  // It would talk at 0, 1, 2 and 3 s; at 2 s it is dead.
  CHECK(host.advance(never).size() == 4);
  CHECK(host.next_event() == never);
}

TEST_CASE("link: loses and doubles at the rates asked for, the same on every call", "[core]") {
  const Link bad{.latency = Duration{10}, .jitter = Duration{5}, .loss = 0.3, .duplication = 0.2};
  int lost = 0, twice = 0;
  for (std::uint64_t seq = 1; seq <= 20'000; ++seq) {
    const auto a = arrivals(bad, 9, scheduler_node(), node(AgentId{1}), seq, epoch);
    const auto b = arrivals(bad, 9, scheduler_node(), node(AgentId{1}), seq, epoch);
    REQUIRE(a.count == b.count);
    lost += a.count == 0;
    twice += a.count == 2;
    for (int i = 0; i < a.count; ++i) {
      REQUIRE(a.at[i] == b.at[i]);
      REQUIRE(a.at[i] >= epoch + bad.latency);
      REQUIRE(a.at[i] < epoch + bad.latency + bad.jitter);
    }
  }
  // Binomial: 6000 +- 4 sigma (65) and 0.7 * 0.2 * 20000 = 2800 +- 4 sigma (49).
  CHECK(std::abs(lost - 6000) < 260);
  CHECK(std::abs(twice - 2800) < 200);
}

}  // namespace
}  // namespace furrow
