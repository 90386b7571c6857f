#pragma once

#include "app/results/flown.hpp"
#include "app/results/report/shares.hpp"
#include "app/results/result.hpp"

#include <string>

namespace furrow::app {

/// The field as HTML: what was planned and, once flown, the true tracks and how far off the lines
/// they were, with a legend. North is up.
std::string map_figure(const MissionRecord& record, const Flown& flown, const Result& result,
                       const Colours& colours);

}  // namespace furrow::app
