#pragma once
// The one use of threads in planning: the same answers as one after another, sooner.

#include <cstddef>
#include <future>
#include <utility>
#include <vector>

namespace furrow::planner {

/// `make(0)` to `make(count - 1)` in this order, made at the same time where threads are to be had.
/// @param make     Reads what it shares with the others, and writes nothing.
/// @param threads  That run at a time, at most; 0: as many as there are answers.
template <class Make>
auto at_once(std::size_t count, const Make& make, std::size_t threads = 0) {
  using Made = decltype(make(std::size_t{}));
  std::vector<std::future<Made>> going;
  going.reserve(count);
  std::vector<Made> made;
  made.reserve(count);
  const auto finish_next = [&] { made.push_back(going[made.size()].get()); };
  for (std::size_t i = 0; i < count; ++i) {
    if (threads > 0 && going.size() - made.size() == threads) finish_next();
    going.push_back(std::async([&make, i] { return make(i); }));
  }
  while (made.size() < count) finish_next();
  return made;
}

}  // namespace furrow::planner
