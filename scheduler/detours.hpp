#pragma once
// What obstacles met in flight make of the work that is left.

#include "planner/avoidance/onboard.hpp"
#include "planner/coverage/route.hpp"

#include <vector>

namespace furrow::scheduler {

/// The detours of `route` as aircraft lay them around what `room` holds, all of a strip at the cell
/// at which it leaves its line. Strips that are blocked get none. Empty where no strip is led
/// around anything.
///
/// Cost: below 1 ms for a strip that meets something.
std::vector<planner::MetDetour> detours(const planner::Route& route, const planner::Room& room,
                                        Length turn_radius, planner::DetourWeights weights);

}  // namespace furrow::scheduler
