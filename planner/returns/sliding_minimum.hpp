#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace furrow::planner {

/// The least of the keys that were pushed and have not slid out of the window. Positions are pushed
/// in one direction and slide out in the same order. Amortised O(1).
class SlidingMinimum {
 public:
  void push(std::uint32_t position, double key) {
    while (entries_.size() > head_ && entries_.back().key >= key) entries_.pop_back();
    if (entries_.size() == head_) {
      entries_.clear();
      head_ = 0;
    }
    entries_.push_back({key, position});
  }

  /// Drops, from the oldest on, positions for which `gone` holds.
  template <class Gone>
  void drop(Gone gone) {
    while (head_ < entries_.size() && gone(entries_[head_].position)) ++head_;
    if (head_ > kept_gone && 2 * head_ > entries_.size()) {
      entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(head_));
      head_ = 0;
    }
  }

  /// Infinite if nothing is in the window.
  double least() const {
    return head_ < entries_.size() ? entries_[head_].key : std::numeric_limits<double>::infinity();
  }

 private:
  struct Entry {
    double key;
    std::uint32_t position;
  };
  static constexpr std::size_t kept_gone = 32;  // below this, giving memory back is not worth it
  std::vector<Entry> entries_;                  // keys rise from head_ on
  std::size_t head_ = 0;
};

}  // namespace furrow::planner
