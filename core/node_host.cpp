#include "core/node_host.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <tuple>

namespace furrow {

bool NodeHost::Earlier::operator()(const Arrival& a, const Arrival& b) const {
  return std::tie(a.at, a.envelope.from, a.envelope.seq) <
         std::tie(b.at, b.envelope.from, b.envelope.seq);
}

Instant NodeHost::Member::next_event() const {
  const Instant next = arrivals.empty() ? wake : std::min(wake, arrivals.begin()->at);
  return next < dies ? next : never;
}

void NodeHost::add(NodeId id, AnyNode node, Instant first, Instant dies) {
  const bool is_new = members_.emplace(id, Member{std::move(node), first, first, dies}).second;
  require(is_new, "a host holds each node once");
}

void NodeHost::deliver(const Envelope& envelope) {
  for (auto& [id, member] : members_) {
    if (!is_recipient(id, envelope)) continue;
    const Arrivals when = arrivals(link_, seed_, envelope.from, id, envelope.seq, envelope.sent);
    for (int i = 0; i < when.count; ++i) {
      if (when.at[i] >= member.first) member.arrivals.insert({when.at[i], envelope});
    }
  }
}

Instant NodeHost::next_event() const {
  Instant next = never;
  for (const auto& [id, member] : members_) next = std::min(next, member.next_event());
  return next;
}

std::vector<Envelope> NodeHost::advance(Instant limit) {
  std::vector<Envelope> sent;
  for (auto& [id, member] : members_) {
    for (Instant now = member.next_event(); now < limit; now = member.next_event()) {
      Inbox inbox;
      while (!member.arrivals.empty() && member.arrivals.begin()->at <= now) {
        auto arrival = member.arrivals.extract(member.arrivals.begin());
        inbox.push_back(std::move(arrival.value().envelope));
      }
      Outbox out = member.node.step(inbox, now);
      require(out.wake > now, "a node wakes later than now");
      member.wake = out.wake;
      for (Body& body : out.messages) {
        sent.push_back({id, ++member.last_seq, now, std::move(body)});
      }
    }
  }
  std::sort(sent.begin(), sent.end(), [](const Envelope& a, const Envelope& b) {
    return std::tie(a.sent, a.from, a.seq) < std::tie(b.sent, b.from, b.seq);
  });
  return sent;
}

}  // namespace furrow
