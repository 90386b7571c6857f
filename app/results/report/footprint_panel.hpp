#pragma once

#include "app/results/flown.hpp"

#include <string>

namespace furrow::app {

/// The ground as sprayed: each run of the boom as wide as it is, so that ground sprayed twice is
/// darker; ground left out; and the obstacles met in flight. Empty where cells are walked, which
/// the other panels show.
/// @param flown  Null when only planned.
std::string footprint_panel(const MissionRecord& record, const Flown* flown);

/// What its colours mean, as items of a list.
std::string footprint_legend(const MissionRecord& record);

}  // namespace furrow::app
