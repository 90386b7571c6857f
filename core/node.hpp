#pragma once

#include "core/messages.hpp"
#include "core/time.hpp"

#include <concepts>
#include <memory>
#include <vector>

namespace furrow {

/// What reached a node since its last step, ordered by arrival, then sender, then sequence number.
using Inbox = std::vector<Envelope>;

/// What a node answers.
struct Outbox {
  std::vector<Body> messages;  ///< In the order in which they are sent.
  Instant wake = never;        ///< Step again then, whatever arrives. Later than `now`.
};

/// A process without its plumbing: state that moves on messages and time, and answers in messages.
///
/// `step` depends on nothing but the node, the inbox and `now`; `now` never goes back. The first
/// step is at the mission's epoch with an empty inbox. Two shells run the same node:
/// `transport` over Fast DDS, and `sim` over a lossy bus, both through a NodeHost.
template <class N>
concept Node = requires(N node, const Inbox& inbox, Instant now) {
  { node.step(inbox, now) } -> std::same_as<Outbox>;
};

/// Any node, by value.
class AnyNode {
 public:
  template <Node N>
  explicit AnyNode(N node) : held_{std::make_unique<Held<N>>(std::move(node))} {}

  Outbox step(const Inbox& inbox, Instant now) { return held_->step(inbox, now); }

 private:
  struct Erased {
    virtual ~Erased() = default;
    virtual Outbox step(const Inbox& inbox, Instant now) = 0;
  };
  template <Node N>
  struct Held final : Erased {
    explicit Held(N n) : node{std::move(n)} {}
    Outbox step(const Inbox& inbox, Instant now) override { return node.step(inbox, now); }
    N node;
  };
  std::unique_ptr<Erased> held_;
};

}  // namespace furrow
