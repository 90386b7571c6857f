#include "sim/simulate.hpp"

#include <catch2/catch.hpp>

namespace furrow::sim {
namespace {

constexpr Link radio{.latency = Duration{50'000'000}, .jitter = {}, .loss = 0, .duplication = 0};
constexpr Duration second{1'000'000'000};

// A scheduler that ends the mission after `beats` seconds.
struct Metronome {
  int beats;
  Outbox step(const Inbox&, Instant now) {
    SchedulerState state{};
    state.phase = beats-- == 0 ? MissionPhase::finished : MissionPhase::flying;
    return {.messages = {state}, .wake = now + second};
  }
};

NodeHost with_metronome(int beats) {
  NodeHost host{radio, 1};
  host.add(scheduler_node(), AnyNode{Metronome{beats}}, Instant{});
  return host;
}

TEST_CASE("simulate: ends at the instant at which the scheduler says so", "[sim]") {
  NodeHost host = with_metronome(3);
  const Log log = simulate(host, radio.latency, never);
  CHECK(log.finished);
  CHECK(log.ended == Instant{3 * second});
  CHECK(log.envelopes.size() == 4);  // at 0, 1, 2 and 3 s
}

TEST_CASE("simulate: gives up after the instant of the limit", "[sim]") {
  NodeHost host = with_metronome(100);
  const Log log = simulate(host, radio.latency, Instant{2 * second});
  CHECK_FALSE(log.finished);
  CHECK(log.ended == Instant{2 * second});
  CHECK(log.envelopes.size() == 3);  // at 0, 1 and 2 s
}

TEST_CASE("simulate: what the scheduler says at the instant of the limit ends the mission",
          "[sim]") {
  NodeHost host = with_metronome(2);
  const Log log = simulate(host, radio.latency, Instant{2 * second});
  CHECK(log.finished);
  CHECK(log.ended == Instant{2 * second});
}

TEST_CASE("simulate: stops when the watch says so, and keeps what was said", "[sim]") {
  NodeHost host = with_metronome(100);
  const Log log = simulate(host, radio.latency, never,
                           [](const auto& sent) { return sent.back().sent < Instant{second}; });
  CHECK_FALSE(log.finished);
  CHECK(log.ended == Instant{second});
  CHECK(log.envelopes.size() == 2);
}

}  // namespace
}  // namespace furrow::sim
