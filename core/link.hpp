#pragma once

#include "core/ids.hpp"
#include "core/time.hpp"

#include <cstdint>

namespace furrow {

/// The radio between nodes, the same for every pair.
struct Link {
  Duration latency;    ///< Least time on the way; > 0, the lookahead of simulated time.
  Duration jitter;     ///< Added uniformly from [0, jitter).
  double loss;         ///< Chance that a message is lost to one recipient, 0 <= p < 1.
  double duplication;  ///< Chance that it arrives twice, 0 <= p < 1.
};

/// When one message reaches one recipient: never, once or twice.
struct Arrivals {
  int count;
  Instant at[2];
};

/// A pure function of its arguments, so that every shell decides alike and no order of events
/// matters. No arrival is earlier than `sent + link.latency`.
Arrivals arrivals(const Link& link, std::uint64_t seed, NodeId from, NodeId to, std::uint64_t seq,
                  Instant sent);

}  // namespace furrow
