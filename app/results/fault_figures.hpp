#pragma once

#include "app/results/flown.hpp"
#include "app/results/result.hpp"

#include <vector>

namespace furrow::app {

/// The scenario's faults, and when the fleet first told of each.
std::vector<FaultFigures> fault_figures(const MissionRecord& record, const Flown& flown);

}  // namespace furrow::app
