#pragma once

#include "scheduler/joint_plan.hpp"
#include "scheduler/path_model.hpp"

#include <vector>

namespace furrow::scheduler {

/// What a plan's flights take beyond constant speeds, as lines through them by the ways between
/// strips of each. By aircraft: those that are as quick lose alike; who does not fly loses nothing.
std::vector<FlightLoss> flight_losses(const FlownLists& flown);

}  // namespace furrow::scheduler
