#pragma once
// A small fleet whose every word depends on all that was heard before, in order: two runs agree
// only if every delivery does.

#include "core/node_host.hpp"
#include "core/random.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace furrow::toy {

inline constexpr Duration second{1'000'000'000};
inline constexpr Link bad_radio{.latency = Duration{50'000'000},
                                .jitter = Duration{120'000'000},
                                .loss = 0.05,
                                .duplication = 0.1};

struct Fleet {
  std::uint32_t agents;
  std::uint32_t stations;
  int seconds;  ///< The scheduler says that it has finished then.
  std::uint64_t seed = 7;
};

/// A digest of what a node has heard.
class Memory {
 public:
  void hear(const Inbox& inbox, Instant now) {
    for (const Envelope& e : inbox) {
      const auto kind = static_cast<std::uint64_t>(e.from.kind);
      digest_ = seed_for(digest_,
                         {kind, e.from.number, e.seq, e.body.index(), count(e.sent), count(now)});
    }
  }
  std::uint64_t digest() const { return digest_; }

 private:
  static std::uint64_t count(Instant t) {
    return static_cast<std::uint64_t>(t.time_since_epoch().count());
  }
  std::uint64_t digest_ = 1;
};

/// Once a second, and in answer to whatever it hears: at most at the next full second.
inline Instant next_second(Instant now) {
  const auto passed = now.time_since_epoch() / second;
  return Instant{(passed + 1) * second};
}

struct Scheduler {
  Fleet fleet;
  Memory memory{};
  std::uint32_t revision = 0;

  Outbox step(const Inbox& inbox, Instant now) {
    memory.hear(inbox, now);
    Outbox out{.messages = {}, .wake = next_second(now)};
    for (const Envelope& e : inbox) {
      if (const auto* state = std::get_if<AgentState>(&e.body)) {
        out.messages.push_back(WorkGrant{.agent = state->agent,
                                         .target_boot = state->boot,
                                         .epoch = Epoch{1},
                                         .revision = revision,
                                         .closed_through = memory.digest(),
                                         .windows = {{e.seq, {1, 2}}}});
      }
    }
    if (now.time_since_epoch() % second != Duration{}) return out;
    const bool is_over = now.time_since_epoch() >= fleet.seconds * second;
    for (std::uint32_t a = 1; a <= fleet.agents && revision < 3; ++a) {
      out.messages.push_back(Command{.agent = AgentId{a},
                                     .target_boot = BootId{1},
                                     .epoch = Epoch{1},
                                     .revision = revision,
                                     .sorties = {}});
    }
    ++revision;
    out.messages.push_back(
        SchedulerState{.epoch = Epoch{1},
                       .phase = is_over ? MissionPhase::finished : MissionPhase::flying,
                       .completed = is_over,
                       .sprayed_cells = static_cast<std::uint32_t>(memory.digest()),
                       .open_cells = 0,
                       .abandoned_cells = 0,
                       .lost = {}});
    return out;
  }
};

struct Station {
  StationId id;
  Memory memory{};
  std::uint64_t token = 0;

  Outbox step(const Inbox& inbox, Instant now) {
    memory.hear(inbox, now);
    Outbox out{.messages = {}, .wake = next_second(now)};
    for (const Envelope& e : inbox) {
      if (const auto* claim = std::get_if<ServiceClaim>(&e.body)) {
        out.messages.push_back(ServiceGrant{.agent = claim->agent,
                                            .station = id,
                                            .claim = claim->claim,
                                            .bay = 1,
                                            .token = ++token,
                                            .starts = now,
                                            .ready = now + second,
                                            .expires = now + 2 * second});
      }
    }
    out.messages.push_back(Event{"station", std::to_string(memory.digest())});
    return out;
  }
};

struct Agent {
  AgentId id;
  std::uint32_t stations;
  Memory memory{};
  std::uint64_t claims = 0;
  Instant due{};

  Outbox step(const Inbox& inbox, Instant now) {
    memory.hear(inbox, now);
    if (now < due) return {.messages = {}, .wake = due};
    // Agents step at times of their own, so that rounds of one member alone occur as well.
    due = next_second(now) + number(id) * Duration{3'000'000};
    Outbox out{.messages = {}, .wake = due};
    AgentState state{};
    state.agent = id;
    state.boot = BootId{1};
    state.phase = Phase::spray;
    state.last_grant = memory.digest();
    out.messages.push_back(state);
    if (memory.digest() % 3 == 0 && stations > 0) {
      out.messages.push_back(ServiceClaim{.agent = id,
                                          .boot = BootId{1},
                                          .station = StationId{1 + number(id) % stations},
                                          .claim = ++claims,
                                          .first_claimed = now,
                                          .status = ClaimStatus::waiting,
                                          .token = 0,
                                          .swap = true,
                                          .fill = 0.5});
    }
    return out;
  }
};

inline void add(NodeHost& host, const Fleet& fleet, NodeId id, Instant first = Instant{}) {
  switch (id.kind) {
    case NodeKind::scheduler: host.add(id, AnyNode{Scheduler{fleet}}, first); break;
    case NodeKind::station: host.add(id, AnyNode{Station{StationId{id.number}}}, first); break;
    case NodeKind::agent:
      host.add(id, AnyNode{Agent{AgentId{id.number}, fleet.stations}}, first);
      break;
    case NodeKind::director: break;  // hosts itself
  }
}

/// All nodes of a fleet.
inline std::vector<NodeId> nodes(const Fleet& fleet) {
  std::vector<NodeId> all{scheduler_node()};
  for (std::uint32_t s = 1; s <= fleet.stations; ++s) all.push_back(node(StationId{s}));
  for (std::uint32_t a = 1; a <= fleet.agents; ++a) all.push_back(node(AgentId{a}));
  return all;
}

/// The log of the same fleet in one process, up to the scheduler's farewell.
inline std::vector<Envelope> log_in_one_host(const Fleet& fleet) {
  NodeHost host{bad_radio, fleet.seed};
  for (const NodeId id : nodes(fleet)) add(host, fleet, id);
  std::vector<Envelope> log;
  std::optional<Instant> end;
  while (!end) {
    const std::vector<Envelope> sent = host.advance(host.next_event() + bad_radio.latency);
    for (const Envelope& e : sent) {
      host.deliver(e);
      const auto* state = std::get_if<SchedulerState>(&e.body);
      if (!end && state && state->phase == MissionPhase::finished) end = e.sent;
      if (!end || e.sent <= *end) log.push_back(e);
    }
  }
  return log;
}

}  // namespace furrow::toy
