#include "supply/supply_node.hpp"

#include <algorithm>
#include <string>

namespace furrow::supply {
namespace {

/// The first whole multiple of `period` after `now`.
Instant next_multiple(Duration period, Instant now) {
  return Instant{(now.time_since_epoch() / period + 1) * period};
}

}  // namespace

SupplyNode::SupplyNode(SupplySettings settings)
    : settings_{std::move(settings)}, queue_{settings_.station, settings_.terms, settings_.tanks} {}

ServiceGrant SupplyNode::grant(const Visit& visit) const {
  return {.agent = visit.agent,
          .station = settings_.station.id,
          .claim = visit.claim,
          .bay = visit.bay,
          .token = visit.token,
          .starts = visit.starts,
          .ready = visit.ready,
          .expires = visit.expires,
          .swap = visit.gives_swap,
          .fill = visit.gives_fill};
}

ServiceGrant SupplyNode::refusal(const Visit& visit, Instant now) const {
  return {.agent = visit.agent,
          .station = settings_.station.id,
          .claim = visit.claim,
          .bay = 0,
          .token = 0,
          .starts = now,
          .ready = now,
          .expires = visit.expires,
          .swap = false,
          .fill = 0.0};
}

StationState SupplyNode::state(Instant now) const {
  StationState state{.station = settings_.station.id,
                     .bays = {},
                     .queue = {},
                     .swaps = queue_.handed_out().swaps,
                     .filled = queue_.filled(),
                     .open_bays = queue_.open_bays(),
                     .next_free = queue_.next_free(now)};
  for (std::uint32_t bay = 1; bay <= settings_.station.bays; ++bay) {
    state.bays.push_back({.bay = bay, .occupied = false, .agent = {}, .token = 0, .ready = {}});
  }
  for (const Visit& v : queue_.in_bay()) {
    state.bays[v.bay - 1] = {v.bay, true, v.agent, v.token, v.ready};
  }
  for (const Visit& v : queue_.waiting()) state.queue.push_back(v.agent);
  return state;
}

/// Sends the state when it is due: at the next whole second after a change, else every 5 s.
void SupplyNode::report(Outbox& out, Instant now) {
  if (now >= state_due_) {
    out.messages.push_back(state(now));
    reported_ = queue_.changes();
    state_due_ = next_multiple(std::chrono::seconds{5}, now);
  }
  if (queue_.changes() != reported_)
    state_due_ = std::min(state_due_, next_multiple(std::chrono::seconds{1}, now));
}

void SupplyNode::shut_bays(Outbox& out, Instant now) {
  for (; shut_ < settings_.shuttings.size() && settings_.shuttings[shut_].at <= now; ++shut_) {
    const std::uint32_t bay = settings_.shuttings[shut_].bay;
    queue_.shut(bay);
    out.messages.push_back(
        Event{"bay_down", text(node(settings_.station.id)) + " shuts bay " + std::to_string(bay) +
                              ", " + std::to_string(queue_.open_bays()) + " of " +
                              std::to_string(settings_.station.bays) + " are left"});
  }
}

Outbox SupplyNode::step(const Inbox& inbox, Instant now) {
  Outbox out;
  shut_bays(out, now);
  std::vector<Visit> holders;
  for (const Envelope& envelope : inbox) {
    const auto* claim = std::get_if<ServiceClaim>(&envelope.body);
    if (claim == nullptr) continue;
    const auto visit = queue_.hear(*claim, now);
    if (visit && visit->bay != 0) holders.push_back(*visit);
  }
  const std::vector<Visit> served = queue_.advance(now);
  for (const Visit& visit : queue_.waiting()) {
    if (queue_.lacks(visit, now)) out.messages.push_back(refusal(visit, now));
  }
  for (const Visit& visit : holders) out.messages.push_back(grant(visit));
  for (const Visit& visit : served) out.messages.push_back(grant(visit));
  report(out, now);
  out.wake = std::min(state_due_, queue_.next_event());
  if (shut_ < settings_.shuttings.size()) {
    out.wake = std::min(out.wake, settings_.shuttings[shut_].at);
  }
  return out;
}

}  // namespace furrow::supply
