#pragma once

#include "app/results/mission_record.hpp"
#include "app/results/result.hpp"

#include <string>
#include <vector>

namespace furrow::app {

/// What was done as it had to be, though nobody would wish it, in sentences: ground that planned
/// rows leave out, more than a thousandth of the land; ways over ground that is not of the field;
/// turns tighter than aircraft fly; ground too steep for the heights to be kept; who left the field
/// around an obstacle.
/// @param result  Its coverage and fleet figures count.
std::vector<std::string> warnings(const Result& result, const MissionRecord& record);

}  // namespace furrow::app
