#pragma once

#include "core/node_host.hpp"

#include <functional>
#include <vector>

namespace furrow::sim {

/// What was said in a run, and how it ended.
struct Log {
  std::vector<Envelope>
      envelopes;  ///< Ordered by time, sender, sequence number; none after `ended`.
  Instant ended;
  bool finished;  ///< The scheduler ended the mission; otherwise the limit or an interrupt did.
};

/// Called with each batch of envelopes, in order; answers whether to go on.
using Watch = std::function<bool(const std::vector<Envelope>&)>;

/// Runs every node of `host` on a virtual clock until the scheduler has finished, nothing is left
/// to happen, or `limit` is over: what happens at that very instant still does.
///
/// @param host     All nodes of the run.
/// @param latency  Of the host's link: the width of the windows in which nodes advance.
Log simulate(NodeHost& host, Duration latency, Instant limit, const Watch& watch = {});

}  // namespace furrow::sim
