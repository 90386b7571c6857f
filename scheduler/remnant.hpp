#pragma once

#include "core/work.hpp"
#include "planner/coverage/route.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace furrow::scheduler {

/// Parts of a route, as a route of its own, so that all planning works on it: what is left of it,
/// or the order in which a fleet flies it.
struct Remnant {
  planner::Route route;              ///< Strips cut to what the runs have of them, in their order.
  std::vector<std::uint32_t> cells;  ///< By cell of `route`: the same cell of the whole route.
};

/// Strips that follow each other as they did keep the way between them; the others are joined by
/// the shortest way over the land.
///
/// @param runs  Cells of `whole` in the order flown: apart, at least one.
Remnant remnant(const planner::Route& whole, std::span<const CellRange> runs);

/// `runs` in order, those that touch joined. @pre None overlap.
std::vector<CellRange> joined(std::vector<CellRange> runs);

}  // namespace furrow::scheduler
