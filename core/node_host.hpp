#pragma once

#include "core/link.hpp"
#include "core/node.hpp"

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace furrow {

/// Some nodes of a run, what is on its way to them, and when each wants to be woken.
///
/// Both shells run nodes through it: `sim` all of them in one host, `transport` one host in each
/// process. Between nodes nothing travels faster than the link's latency, so hosts may be advanced
/// independently up to any limit before which no message can still arrive, with the same result.
class NodeHost {
 public:
  NodeHost(Link link, std::uint64_t seed) : link_{link}, seed_{seed} {}

  /// Its first step will be at `first`, and it hears nothing that arrives before; from `dies` on it
  /// neither steps nor sends any more, as after a crash.
  void add(NodeId id, AnyNode node, Instant first, Instant dies = never);

  bool holds(NodeId id) const { return members_.contains(id); }

  /// Queues the envelope for each node here that acts on it, as the link decides.
  /// @pre No such arrival is before the last limit given to `advance`.
  void deliver(const Envelope& envelope);

  /// When something happens next; `never` when all are done.
  Instant next_event() const;

  /// Steps every node through all its events before `limit`, in time order.
  ///
  /// @return  What was sent, ordered by time, then sender, then sequence number. It is not
  ///          delivered back: the shell hands each envelope to `deliver` of every host, this one
  ///          included.
  std::vector<Envelope> advance(Instant limit);

 private:
  struct Arrival {
    Instant at;
    Envelope envelope;
  };
  struct Earlier {
    bool operator()(const Arrival& a, const Arrival& b) const;
  };
  struct Member {
    AnyNode node;
    Instant first;
    Instant wake;
    Instant dies;
    std::uint64_t last_seq = 0;
    std::multiset<Arrival, Earlier> arrivals{};

    Instant next_event() const;
  };

  Link link_;
  std::uint64_t seed_;
  std::map<NodeId, Member> members_;
};

}  // namespace furrow
