#pragma once
// A scheduler and a station reduced to what one aircraft needs to be put through its paces.

#include "agents/agent_node.hpp"
#include "core/node_host.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace furrow::agents {

inline constexpr Duration second{1'000'000'000};
inline constexpr Instant mission_start{};
inline constexpr AgentId agent_7{7};
inline constexpr BootId boot_1{1};

inline Vehicle sprayer() {
  return {.id = agent_7,
          .home = at_m(0, 0),
          .swath = metres(2),
          .spray_speed = metres_per_second(3),
          .ferry_speed = metres_per_second(6),
          .spray_endurance = seconds(900),
          .flight_endurance = seconds(1500),
          .battery_reserve = 0.0,
          .tank = litres(10),
          .min_turn_radius = {},
          .acceleration_limit = metres_per_second2(3),
          .gnss = {}};
}

inline Station depot() {
  return {.id = StationId{1},
          .position = at_m(0, 0),
          .bays = 1,
          .battery_swap = seconds(60),
          .fill_base = seconds(20),
          .fill_full = seconds(60)};
}

inline AgentSettings settings_of(const Vehicle& vehicle, Wind wind = {}) {
  return {.vehicle = vehicle,
          .stations = {depot()},
          .wind = wind,

          .seed = 5,
          .boot = boot_1};
}

/// Strips of `cells` cells of 2 m, first centre (1, 1), up and down by turns, as one piece each.
inline std::vector<Piece> strips(std::uint32_t count, std::uint32_t cells) {
  std::vector<Piece> pieces;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x = 1.0 + 2.0 * i, top = 2.0 * cells - 1.0;
    const bool is_up = i % 2 == 0;
    const FieldPoint from = at_m(x, is_up ? 1.0 : top), to = at_m(x, is_up ? top : 1.0);
    const FieldPoint entry = pieces.empty() ? from : pieces.back().to;
    pieces.push_back(
        {.cells = {i * cells, cells}, .entry = entry, .from = from, .to = to, .exit = to});
  }
  return pieces;
}

/// Cuts `pieces` into two sorties after cell `last`.
inline std::vector<SortieOrder> two_sorties(const std::vector<Piece>& pieces, std::uint32_t last) {
  std::vector<SortieOrder> sorties{{.pieces = {}, .station = StationId{1}},
                                   {.pieces = {}, .station = StationId{1}}};
  for (const Piece& p : pieces) {
    const auto center = [&](std::uint32_t i) {
      const double share = static_cast<double>(i) / (p.cells.count - 1);
      return FieldPoint{p.from.x + share * (p.to.x - p.from.x),
                        p.from.y + share * (p.to.y - p.from.y)};
    };
    if (last < p.cells.first) {
      sorties[1].pieces.push_back(p);
    } else if (last + 1 >= end(p.cells)) {
      sorties[0].pieces.push_back(p);
    } else {
      const std::uint32_t n = last + 1 - p.cells.first;
      sorties[0].pieces.push_back(
          {{p.cells.first, n}, p.entry, p.from, center(n - 1), center(n - 1)});
      sorties[1].pieces.push_back(
          {{last + 1, p.cells.count - n}, center(n - 1), center(n), p.to, p.to});
    }
  }
  return sorties;
}

/// Commands one plan at the first introduction and until it is answered, grants each piece and what
/// closures leave over.
struct ScriptedScheduler {
  std::vector<SortieOrder> sorties;
  std::function<bool(CellRange, Instant)> may_grant = [](CellRange, Instant) { return true; };
  int repeats = 1;  // each message so many times
  /// What becomes of a claimed flight; nothing: no answer.
  std::function<std::optional<FlightGrant>(const FlightClaim&)> clears = [](const FlightClaim& c) {
    return FlightGrant{c.agent, c.boot, c.claim, true, c.track.front().at};
  };
  Instant silent_from = never;

  bool commanded = false, acknowledged = false, finished = false;
  Instant commanded_at{};
  std::uint64_t next_id = 1, closed_through = 0;
  std::vector<CellRange> ungranted{};
  std::map<std::uint64_t, GrantWindow> open{};

  Outbox step(const Inbox& inbox, Instant now) {
    Outbox out;
    if (now >= silent_from) return out;
    bool is_introduced = commanded;
    for (const auto& e : inbox) {
      is_introduced |= std::holds_alternative<AgentInfo>(e.body);
      if (const auto* r = std::get_if<WorkReport>(&e.body)) book(*r);
      if (const auto* c = std::get_if<FlightClaim>(&e.body)) {
        if (const auto answer = clears(*c)) out.messages.push_back(*answer);
      }
      if (const auto* s = std::get_if<AgentState>(&e.body)) finished |= s->phase == Phase::done;
      if (const auto* a = std::get_if<CommandAck>(&e.body)) {
        acknowledged |= a->status != AckStatus::received;
      }
    }
    if (is_introduced && !commanded) {
      commanded = true;
      for (const auto& s : sorties) {
        for (const auto& p : s.pieces) ungranted.push_back(p.cells);
      }
      commanded_at = now - 2 * second;
    }
    if (commanded && !acknowledged && now >= commanded_at + 2 * second) {
      out.messages.push_back(Command{agent_7, boot_1, Epoch{1}, 1, sorties});
      commanded_at = now;
    }
    while (!ungranted.empty() && open.size() < 2 && may_grant(ungranted.front(), now)) {
      open[next_id] = {next_id, ungranted.front()};
      ++next_id;
      ungranted.erase(ungranted.begin());
    }
    WorkGrant level{agent_7, boot_1, Epoch{1}, 1, closed_through, {}};
    for (const auto& [id, window] : open) level.windows.push_back(window);
    for (int i = 0; commanded && i < repeats; ++i) out.messages.push_back(level);
    SchedulerState state{};
    state.epoch = Epoch{1};
    state.phase = finished ? MissionPhase::finished : MissionPhase::flying;
    out.messages.push_back(state);
    if (!finished) out.wake = now + second;
    return out;
  }

  void book(const WorkReport& report) {
    std::vector<CellRange> left;
    for (const Closure& c : report.closures) {
      if (open.erase(c.grant) == 0) continue;
      closed_through = std::max(closed_through, c.grant);
      if (c.sprayed < c.cells.count) {
        left.push_back({c.cells.first + c.sprayed, c.cells.count - c.sprayed});
      }
    }
    ungranted.insert(ungranted.begin(), left.begin(), left.end());
  }
};

/// One bay, always free: serves each claim once, out of what it has.
struct ScriptedStation {
  double tanks_left = 1e9;
  std::uint64_t last_claim = 0;
  Outbox step(const Inbox& inbox, Instant now) {
    Outbox out;
    for (const auto& e : inbox) {
      const auto* claim = std::get_if<ServiceClaim>(&e.body);
      if (!claim || claim->status != ClaimStatus::waiting || claim->claim <= last_claim) continue;
      last_claim = claim->claim;
      const double fill = std::min(claim->fill, tanks_left);
      const bool gives = claim->swap || fill > 0.0;
      tanks_left -= fill;
      const Instant ready = now + duration(service_time(depot(), claim->swap, fill));
      out.messages.push_back(ServiceGrant{.agent = claim->agent,
                                          .station = claim->station,
                                          .claim = claim->claim,
                                          .bay = gives ? 1u : 0u,
                                          .token = gives ? claim->claim : 0u,
                                          .starts = now,
                                          .ready = ready,
                                          .expires = ready + 10 * second,
                                          .swap = claim->swap,
                                          .fill = fill});
    }
    return out;
  }
};

inline constexpr Link radio{
    .latency = Duration{50'000'000}, .jitter = {}, .loss = 0, .duplication = 0};

/// Everything said in a run of one aircraft until `limit` or the end.
inline std::vector<Envelope> fly(const AgentSettings& settings, ScriptedScheduler scheduler,
                                 Instant limit, Link link = radio, ScriptedStation station = {}) {
  NodeHost host{link, 3};
  host.add(scheduler_node(), AnyNode{std::move(scheduler)}, Instant{});
  host.add(node(StationId{1}), AnyNode{station}, Instant{});
  host.add(node(agent_7), AnyNode{AgentNode{settings}}, Instant{});
  std::vector<Envelope> log;
  while (host.next_event() < limit) {
    const auto sent = host.advance(host.next_event() + link.latency);
    for (const auto& e : sent) host.deliver(e);
    log.insert(log.end(), sent.begin(), sent.end());
  }
  return log;
}

/// Steps an agent once a second under `told`, by second; everything that it says.
inline std::vector<Envelope> told_by_second(AgentNode& agent,
                                            const std::map<int, std::vector<Body>>& told,
                                            int to_s) {
  std::vector<Envelope> log;
  std::uint64_t seq = 0;
  for (int s = 0; s < to_s; ++s) {
    const Instant now = mission_start + s * second;
    Inbox inbox;
    if (const auto at = told.find(s); at != told.end()) {
      for (const Body& body : at->second) inbox.push_back({scheduler_node(), ++seq, now, body});
    }
    for (Body& body : agent.step(inbox, now).messages) {
      log.push_back({node(agent_7), log.size() + 1, now, std::move(body)});
    }
  }
  return log;
}

/// All messages of one kind, in order.
template <class M>
std::vector<M> all(const std::vector<Envelope>& log) {
  std::vector<M> found;
  for (const auto& e : log) {
    if (const auto* m = std::get_if<M>(&e.body)) found.push_back(*m);
  }
  return found;
}

/// How often each cell was passed with the valve open.
inline std::map<std::uint32_t, int> passes(const std::vector<Envelope>& log) {
  std::map<std::uint32_t, int> count;
  for (const auto& record : all<FlightRecord>(log)) {
    for (std::uint32_t c = record.cells.first; c < end(record.cells); ++c) ++count[c];
  }
  return count;
}

inline bool each_once(const std::vector<Envelope>& log, std::uint32_t cells) {
  const auto count = passes(log);
  return count.size() == cells &&
         std::all_of(count.begin(), count.end(), [](const auto& c) { return c.second == 1; });
}

/// Phases in the order entered, as heartbeats tell them.
inline std::vector<Phase> phases(const std::vector<Envelope>& log) {
  std::vector<Phase> entered;
  for (const auto& state : all<AgentState>(log)) {
    if (entered.empty() || entered.back() != state.phase) entered.push_back(state.phase);
  }
  return entered;
}

inline constexpr Instant an_hour = mission_start + 3600 * second;

// Three strips of 100 cells, home after the 50th cell of the second.
inline ScriptedScheduler three_strips() { return {.sorties = two_sorties(strips(3, 100), 149)}; }

inline std::vector<std::string> event_kinds(const std::vector<Envelope>& log) {
  std::vector<std::string> kinds;
  for (const Event& e : all<Event>(log)) kinds.push_back(e.kind);
  return kinds;
}

inline bool contains(const std::vector<std::string>& kinds, const std::string& kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

}  // namespace furrow::agents
