#pragma once
// Strips that lie so near to each other that two aircraft are not at work on them at once.

#include "planner/coverage/route.hpp"

#include <vector>

namespace furrow::scheduler {

/// Of each strip of a route, whether another lies nearer to it than `near`, at some place of both:
/// a last row that is shifted onto the one before, rows that end at a round along the edge.
///
/// Time O(n log n + p) for n strips and p pairs at the same distance from the first strip's line.
///
/// @param near  > 0.
std::vector<bool> strips_near_others(const planner::Route& route, Length near);

/// Nearer to each other than this is near for aircraft at work: the separation and what both may be
/// off their lines, 1 m, or a fifth of the swath, so that strips a swath apart are not.
Length near_work(Length separation, Length narrowest_swath);

}  // namespace furrow::scheduler
