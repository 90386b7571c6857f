#pragma once

#include "mission/reader.hpp"
#include "mission/scenario.hpp"

namespace furrow::mission {

/// Reads `survey`, and gives the terrain that was read before the survey's height as work height.
/// @return  Nothing where the field is to be sprayed.
std::optional<planner::SurveySettings> read_survey(const Section& root, Scenario& scenario);

}  // namespace furrow::mission
