#pragma once

#include "app/results/mission_record.hpp"
#include "app/results/result.hpp"

#include <string>

namespace furrow::app {

/// report.html: one file that needs nothing else, on screen and in print.
///
/// @param result  The summary of `record`.
std::string report_html(const MissionRecord& record, const Result& result);

}  // namespace furrow::app
