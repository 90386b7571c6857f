#pragma once
// The topics of the contract that one process writes and reads, messages on one side and samples on
// the other.

#include "core/messages.hpp"
#include "transport/participant.hpp"
#include "transport/wire.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "idl/clock.h"

namespace furrow::transport {

/// Given every sample as it comes, from middleware threads. No envelope: the sample was malformed.
using Heard = std::function<void(Origin, std::size_t topic, std::optional<Envelope>)>;

/// The kinds of some nodes.
Kinds kinds_of(const std::vector<NodeId>& nodes);

class FleetTopics {
 public:
  /// @param listens_to_all  As the recorder does, to all but what it writes; otherwise what
  /// `hosted`
  ///                        act on.
  FleetTopics(Participant& participant, Kinds hosted, bool listens_to_all, TimeMode mode,
              BootId boot, Heard heard);
  ~FleetTopics();

  /// @return  The sample's number in its topic, 0 if the middleware refused it.
  /// @pre The contract lets this process write the topic.
  std::uint64_t publish(const Envelope& envelope);

  /// How many ends each writer and reader of this process has found.
  std::vector<fleet::v1::MatchCount> matches() const;

  /// Keeps the leases of leased topics.
  void assert_alive();

 private:
  struct Out;
  struct In;
  template <std::size_t topic>
  struct OutOf;
  template <std::size_t topic>
  struct InOf;
  template <std::size_t topic>
  void open(Participant& participant, Kinds hosted, bool listens_to_all, TimeMode mode,
            const Heard& heard);

  BootId boot_;
  std::array<std::unique_ptr<Out>, topic_count> out_;
  std::array<std::unique_ptr<In>, topic_count> in_;
};

}  // namespace furrow::transport
