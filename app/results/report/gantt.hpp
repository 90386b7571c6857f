#pragma once

#include "app/results/flown.hpp"
#include "app/results/report/shares.hpp"
#include "app/results/result.hpp"

#include <string>

namespace furrow::app {

/// Who did what when, as HTML: a row per UAV, then a row per bay, over mission time in minutes.
std::string gantt_figure(const Flown& flown, const Result& result, const Colours& colours);

}  // namespace furrow::app
