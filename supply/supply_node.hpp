#pragma once

#include "core/node.hpp"
#include "supply/queue.hpp"

#include <map>

namespace furrow::supply {

struct SupplySettings {
  Station station;
  std::map<AgentId, Volume> tanks;  ///< Of every aircraft that may come, to count litres.
  LeaseTerms terms{.lease = std::chrono::seconds{3}};
};

/// A supply station as a node: takes claims, answers with bays, or that it has nothing left of what
/// is claimed, and says at whole seconds what has changed, or every five seconds that nothing has.
class SupplyNode {
 public:
  explicit SupplyNode(SupplySettings settings);

  Outbox step(const Inbox& inbox, Instant now);

 private:
  ServiceGrant grant(const Visit& visit) const;
  ServiceGrant refusal(const Visit& visit, Instant now) const;
  StationState state() const;
  void report(Outbox& out, Instant now);

  SupplySettings settings_;
  BayQueue queue_;
  Instant state_due_{};         ///< The epoch: a station shows itself at once.
  std::uint64_t reported_ = 0;  ///< Of the queue's changes.
};

}  // namespace furrow::supply
