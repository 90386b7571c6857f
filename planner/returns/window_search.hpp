#pragma once

#include "planner/returns/cost.hpp"
#include "planner/returns/legs.hpp"
#include "planner/returns/problem.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace furrow::planner {

/// The cells at which a local search may return: up to `half_width` cells before and after each
/// return, every `stride`th, and all of `ends`. Rising, without the first and the last cell.
struct Windows {
  std::uint32_t stride, half_width;
};
std::vector<std::uint32_t> cells_in(Windows windows, std::span<const std::uint32_t> returns,
                                    std::span<const std::uint32_t> ends, std::uint32_t last_cell);

/// Returns of less non-spray time than `cutoff_s` that lie at `candidates` only: dynamic
/// programming over candidate and charge used, the latter kept exactly but for one plan in each of
/// 128 buckets, and only for plans that `free` does not rule out. Nearly the best such plan. Empty
/// if none is found, or if it needs no return.
///
/// @param candidates  Rising, between the first and the last cell.
///
/// Time O(candidates x buckets x candidates within one tank), much less the closer the cutoff.
Returns best_among(const ReturnCost& cost, const BatteryFree& free,
                   std::span<const std::uint32_t> candidates, double cutoff_s);

}  // namespace furrow::planner
