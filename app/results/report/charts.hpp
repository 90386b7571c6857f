#pragma once

#include "app/results/flown.hpp"
#include "app/results/mission_record.hpp"
#include "app/results/report/shares.hpp"

#include <string>

namespace furrow::app {

/// True offsets as HTML: how often each occurred, and the root mean square of each strip. Empty
/// where nothing was flown.
std::string deviation_charts(const MissionRecord& record, const Flown& flown,
                             const Colours& colours);

}  // namespace furrow::app
