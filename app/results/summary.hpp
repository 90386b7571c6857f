#pragma once

#include "app/results/flown.hpp"
#include "app/results/result.hpp"

namespace furrow::app {

/// Every figure of a mission: forecasts when it was only planned, else what the log proves.
Result summary(const MissionRecord& record);

/// The same, of a log already read.
Result summary(const MissionRecord& record, const Flown& flown);

}  // namespace furrow::app
