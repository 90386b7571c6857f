#pragma once

#include "core/node.hpp"
#include "supply/queue.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace furrow::supply {

/// A bay that takes nobody more from some instant on; who is in it is served to the end.
struct Shutting {
  Instant at;
  std::uint32_t bay;
};

struct SupplySettings {
  Station station;
  std::map<AgentId, Volume> tanks;  ///< Of every aircraft that may come, to count litres.
  LeaseTerms terms{.lease = std::chrono::seconds{3}};
  std::vector<Shutting> shuttings{};  ///< In order of time.
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
  StationState state(Instant now) const;
  void report(Outbox& out, Instant now);
  void shut_bays(Outbox& out, Instant now);

  SupplySettings settings_;
  BayQueue queue_;
  std::size_t shut_ = 0;        ///< Of the settings' shuttings.
  Instant state_due_{};         ///< The epoch: a station shows itself at once.
  std::uint64_t reported_ = 0;  ///< Of the queue's changes.
};

}  // namespace furrow::supply
