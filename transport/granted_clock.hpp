#pragma once
// The rule by which time is granted. Pure: the director feeds it and sends what it says.

#include "core/messages.hpp"
#include "core/time.hpp"
#include "transport/director.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace furrow::transport {

/// A conservative clock: nobody is let into a time from which a message could still reach it.
///
/// With T the earliest event of all members, every message still to be sent arrives at T + latency
/// or later. So all members with events before that limit step up to it side by side, each
/// holding what was sent to it before.
/// Source: Chandy, Misra 1979; with the window of Lubachevsky 1989.
class GrantedClock {
 public:
  struct Grant {
    std::uint32_t participant;
    /// (participant, topic) -> the last of its samples that concerns this member.
    std::map<std::pair<std::uint32_t, std::size_t>, std::uint64_t> needed;
  };
  struct Round {
    Instant begin, limit;
    std::vector<Grant> grants;  ///< Not empty.
  };

  /// @pre latency > 0
  GrantedClock(const std::vector<MemberPlan>& members, Duration latency);

  /// A member has done everything before the last limit it was granted.
  void report(std::uint32_t participant, Instant next_event);

  /// A member's message, to be told before it reports.
  void sent(std::uint32_t participant, std::size_t topic, std::uint64_t sequence,
            const Envelope& envelope);

  /// A member has died: it is waited for no more.
  void drop(std::uint32_t participant) { members_.erase(participant); }

  /// Whether every granted member has reported.
  bool is_round_done() const;

  /// When something happens next.
  /// @pre is_round_done()
  Instant next_event() const;

  /// Grants time up to one latency after the next event, at most to `last`.
  /// @pre is_round_done() and next_event() < last
  Round next_round(Instant last);

 private:
  struct Member {
    std::vector<NodeId> nodes;
    bool is_out = true;  // granted and not back
    Instant next_event{};
    Instant first_arrival = never;
    std::map<std::pair<std::uint32_t, std::size_t>, std::uint64_t> needed{};

    Instant next() const { return std::min(next_event, first_arrival); }
  };

  Duration latency_;
  std::map<std::uint32_t, Member> members_;
};

}  // namespace furrow::transport
