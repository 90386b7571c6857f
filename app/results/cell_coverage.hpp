#pragma once
// What is sprayed and visited by the cells of the route.

#include "app/results/flown.hpp"
#include "app/results/result.hpp"

#include <vector>

namespace furrow::app {

/// By aircraft: what the plan gives it to spray [m2]; 0 on a survey.
std::vector<double> share_areas_m2(const scheduler::FleetPlan& plan);

/// Every cell of every share, flown exactly.
std::vector<Pass> planned_passes(const scheduler::FleetPlan& plan);

CoverageFigures planned_coverage(const MissionRecord& record);

/// As the ledger and the flight records prove it.
/// @param wetted  Of the same passes.
CoverageFigures flown_coverage(const MissionRecord& record, const Flown& flown,
                               const FootprintFigures& wetted);

SurveyFigures planned_survey(const MissionRecord& record);
SurveyFigures flown_survey(const Flown& flown);

}  // namespace furrow::app
