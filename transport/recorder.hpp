#pragma once
// What both kinds of directors share: the log, and who is still alive.

#include "transport/director.hpp"
#include "transport/mailbox.hpp"

#include <chrono>
#include <set>
#include <vector>

#include "idl/clock.h"

namespace furrow::transport {

using Incoming = Mailbox<fleet::v1::TimeRequest>;

/// The order of the log.
bool is_earlier(const Envelope& a, const Envelope& b);

/// Keeps what is said, in the order in which it is given.
class Recorder {
 public:
  explicit Recorder(const DirectorSettings& settings) : settings_{settings} {}

  void keep(Envelope envelope);

  /// What the director has to say itself, sent at `now`.
  std::vector<Envelope> own_words(Instant now);

  /// The result of a run that ended so.
  DirectorResult result(Ending ending, Instant end, const std::set<std::uint32_t>& died,
                        std::uint64_t rounds, std::uint64_t malformed) &&;

 private:
  const DirectorSettings& settings_;
  std::vector<Envelope> log_;
  std::uint64_t said_ = 0;  // by the director itself
};

/// Asks the settings' callbacks, but not more often than they can bear.
class Watch {
 public:
  Watch(const DirectorSettings& settings, const Incoming& incoming)
      : settings_{settings}, incoming_{incoming} {}

  /// Members found dead since the last call.
  std::vector<std::uint32_t> new_deaths();
  bool is_interrupted();

  const std::set<std::uint32_t>& died() const { return died_; }
  bool has_anyone() const { return died_.size() < settings_.members.size(); }

 private:
  using Clock = std::chrono::steady_clock;
  const DirectorSettings& settings_;
  const Incoming& incoming_;
  std::set<std::uint32_t> died_;
  Clock::time_point asked_dead_{}, asked_interrupt_{};
};

/// "participant 3 (agent 1, agent 2, ...)".
std::string text(const MemberPlan& member);

}  // namespace furrow::transport
