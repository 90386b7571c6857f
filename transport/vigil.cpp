#include "transport/vigil.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace furrow::transport {

Vigil::Vigil(PeerLost lost, std::chrono::milliseconds patience)
    : lost_{lost ? std::move(lost) : [](std::uint32_t) {}}, patience_{patience} {}

Vigil::~Vigil() { end(); }

void Vigil::suspect(std::uint32_t participant) {
  const std::lock_guard lock{mutex_};
  if (is_over_) return;
  due_.emplace(participant, Clock::now() + patience_);
  if (!thread_.joinable()) thread_ = std::thread{[this] { watch(); }};
  changed_.notify_one();
}

void Vigil::hear(std::uint32_t participant) {
  const std::lock_guard lock{mutex_};
  due_.erase(participant);
}

void Vigil::end() {
  {
    const std::lock_guard lock{mutex_};
    is_over_ = true;
    changed_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
}

void Vigil::watch() {
  std::unique_lock lock{mutex_};
  while (!is_over_) {
    if (due_.empty()) {
      changed_.wait(lock);
      continue;
    }
    const auto next = std::min_element(
        due_.begin(), due_.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    const Clock::time_point until = next->second;
    changed_.wait_until(lock, until);
    if (!is_over_) lose_the_overdue(lock);
  }
}

void Vigil::lose_the_overdue(std::unique_lock<std::mutex>& lock) {
  std::vector<std::uint32_t> overdue;
  for (const auto& [participant, due] : due_) {
    if (due <= Clock::now()) overdue.push_back(participant);
  }
  for (const std::uint32_t participant : overdue) due_.erase(participant);
  lock.unlock();
  for (const std::uint32_t participant : overdue) lost_(participant);
  lock.lock();
}

}  // namespace furrow::transport
