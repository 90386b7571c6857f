#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

namespace furrow::transport {

/// Told of each participant that has left, died or gone silent; called from a thread of the
/// transport's own.
using PeerLost = std::function<void(std::uint32_t participant)>;

/// Waits over those whose lease has run out by the middleware's word, until they show themselves
/// again or are lost.
///
/// The middleware keeps one timer for the leases of all writers, and marks whose turn it is when
/// the timer fires, without a look at the time. Where a dead participant is dropped at the moment
/// at which the lease of its writer runs out, the writer is gone before the timer fires, and the
/// next in turn is marked, which lives. It is marked alive again by its next word.
class Vigil {
 public:
  /// @param patience  Longer than between two words of one who lives.
  Vigil(PeerLost lost, std::chrono::milliseconds patience);
  ~Vigil();
  Vigil(const Vigil&) = delete;
  Vigil& operator=(const Vigil&) = delete;

  // Called by middleware threads.
  void suspect(std::uint32_t participant);
  void hear(std::uint32_t participant);
  /// Beyond doubt.
  void lose(std::uint32_t participant) { lost_(participant); }

  /// Nobody is lost any more from then on.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  void watch();
  void lose_the_overdue(std::unique_lock<std::mutex>& lock);

  PeerLost lost_;
  std::chrono::milliseconds patience_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::uint32_t, Clock::time_point> due_;
  bool is_over_ = false;
  std::thread thread_;  // since the first suspicion
};

}  // namespace furrow::transport
