#pragma once
// The one use of threads in planning: the same answers as one after another, sooner.

#include <cstddef>
#include <future>
#include <utility>
#include <vector>

namespace furrow::planner {

/// `make(0)` to `make(count - 1)` in this order, made at the same time where threads are to be had.
/// @param make  Reads what it shares with the others, and writes nothing.
template <class Make>
auto at_once(std::size_t count, const Make& make) {
  using Made = decltype(make(std::size_t{}));
  std::vector<std::future<Made>> going;
  going.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    going.push_back(std::async([&make, i] { return make(i); }));
  std::vector<Made> made;
  made.reserve(count);
  for (std::future<Made>& one : going) made.push_back(one.get());
  return made;
}

}  // namespace furrow::planner
