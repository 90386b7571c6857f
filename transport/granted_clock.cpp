#include "transport/granted_clock.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::transport {

GrantedClock::GrantedClock(const std::vector<MemberPlan>& members, Duration latency)
    : latency_{latency} {
  require(latency > Duration{}, "granted time needs a link with latency");
  for (const MemberPlan& plan : members) members_.emplace(plan.participant, Member{plan.nodes});
}

void GrantedClock::report(std::uint32_t participant, Instant next_event) {
  const auto found = members_.find(participant);
  if (found == members_.end()) return;
  found->second.is_out = false;
  found->second.next_event = next_event;
}

void GrantedClock::sent(std::uint32_t participant, std::size_t topic, std::uint64_t sequence,
                        const Envelope& envelope) {
  for (auto& [other, member] : members_) {
    if (other == participant) continue;  // a member hands its own nodes their mail itself
    const bool concerns = std::any_of(member.nodes.begin(), member.nodes.end(),
                                      [&](NodeId node) { return is_recipient(node, envelope); });
    if (!concerns) continue;
    member.first_arrival = std::min(member.first_arrival, envelope.sent + latency_);
    std::uint64_t& last = member.needed[{participant, topic}];
    last = std::max(last, sequence);
  }
}

bool GrantedClock::is_round_done() const {
  return std::none_of(members_.begin(), members_.end(),
                      [](const auto& entry) { return entry.second.is_out; });
}

Instant GrantedClock::next_event() const {
  require(is_round_done(), "the next event is known once all have reported");
  Instant next = never;
  for (const auto& [participant, member] : members_) next = std::min(next, member.next());
  return next;
}

GrantedClock::Round GrantedClock::next_round(Instant last) {
  const Instant begin = next_event();
  require(begin < last, "a round begins before the last limit");
  Round round{.begin = begin, .limit = std::min(begin + latency_, last), .grants = {}};
  for (auto& [participant, member] : members_) {
    if (member.next() >= round.limit) continue;
    round.grants.push_back({participant, std::exchange(member.needed, {})});
    member.is_out = true;
    member.first_arrival = never;
  }
  return round;
}

}  // namespace furrow::transport
