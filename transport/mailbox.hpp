#pragma once
// Where middleware threads leave what they hear for the one thread that runs a member or the clock.

#include "core/messages.hpp"
#include "transport/participant.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace furrow::transport {

/// How far a writer's samples have been heard without a gap. Instances of a topic are taken apart
/// from each other, so numbers may come out of order.
class Progress {
 public:
  void add(std::uint64_t sequence) {
    ahead_.insert(sequence);
    while (!ahead_.empty() && *ahead_.begin() <= through_ + 1) {
      through_ = std::max(through_, *ahead_.begin());
      ahead_.erase(ahead_.begin());
    }
  }
  std::uint64_t through() const { return through_; }

 private:
  std::uint64_t through_ = 0;
  std::set<std::uint64_t> ahead_;
};

/// A sample of a topic of the contract.
struct Sample {
  Origin origin;
  std::size_t topic;
  Envelope envelope;
};

/// @tparam Note  What the clock protocol sends here: grants to a member, requests to the director.
template <class Note>
class Mailbox {
 public:
  using Clock = std::chrono::steady_clock;

  // Called by middleware threads.
  void put(Origin origin, std::size_t topic, std::optional<Envelope> envelope) {
    const std::lock_guard lock{mutex_};
    progress_[{origin.participant, topic}].add(origin.sequence);
    if (envelope) {
      messages_.push_back({origin, topic, std::move(*envelope)});
    } else {
      ++malformed_;
    }
    if (wants_messages_) changed_.notify_one();
  }
  void note(Note note) {
    const std::lock_guard lock{mutex_};
    notes_.push_back(std::move(note));
    if (notes_.size() >= wanted_notes_) changed_.notify_one();
  }
  void reject() {
    const std::lock_guard lock{mutex_};
    ++malformed_;
  }
  void lose(std::uint32_t participant) {
    const std::lock_guard lock{mutex_};
    lost_.insert(participant);
    changed_.notify_one();
  }

  // Called by the owner's thread. Each waits for at most `patience`, or until a peer is lost.

  /// Notes, as soon as there are `count`.
  std::vector<Note> take_notes(std::size_t count, std::chrono::milliseconds patience) {
    std::unique_lock lock{mutex_};
    wanted_notes_ = count;
    const auto known = lost_.size();
    changed_.wait_for(lock, patience,
                      [&] { return notes_.size() >= count || lost_.size() != known; });
    return std::exchange(notes_, {});
  }

  /// Whether all samples of a topic's writer up to `sequence` are here.
  bool wait_for(std::uint32_t participant, std::size_t topic, std::uint64_t sequence,
                std::chrono::milliseconds patience) {
    std::unique_lock lock{mutex_};
    const Progress& progress = progress_[{participant, topic}];
    const auto known = lost_.size();
    wants_messages_ = true;
    changed_.wait_for(lock, patience,
                      [&] { return progress.through() >= sequence || lost_.size() != known; });
    wants_messages_ = false;
    return progress.through() >= sequence;
  }

  /// Any message.
  void wait_for_message(std::chrono::milliseconds patience) {
    std::unique_lock lock{mutex_};
    wants_messages_ = true;
    changed_.wait_for(lock, patience, [&] { return !messages_.empty(); });
    wants_messages_ = false;
  }

  std::vector<Sample> take_messages() {
    const std::lock_guard lock{mutex_};
    return std::exchange(messages_, {});
  }
  std::set<std::uint32_t> lost() const {
    const std::lock_guard lock{mutex_};
    return lost_;
  }
  bool has_lost(std::uint32_t participant) const {
    const std::lock_guard lock{mutex_};
    return lost_.contains(participant);
  }
  std::uint64_t malformed() const {
    const std::lock_guard lock{mutex_};
    return malformed_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Sample> messages_;
  std::vector<Note> notes_;
  std::map<std::pair<std::uint32_t, std::size_t>, Progress> progress_;
  std::set<std::uint32_t> lost_;
  std::uint64_t malformed_ = 0;
  bool wants_messages_ = false;
  std::size_t wanted_notes_ = 1;
};

}  // namespace furrow::transport
