#pragma once

#include "app/results/flown.hpp"
#include "app/results/result.hpp"
#include "planner/coverage/swath/swath.hpp"

#include <vector>

namespace furrow::app {

/// True areas of a swept field, from the union of footprints: of the strips as planned, or of the
/// tracks as flown.
/// @param flown  Null when only planned.
planner::SprayedAreas sweep_areas(const MissionRecord& record, const Flown* flown);

/// Where the boom was, per aircraft: the strips as planned, or the tracks as flown.
/// @param flown  Null when only planned.
std::vector<std::vector<planner::FlownPlace>> sprayed_tracks(const MissionRecord& record,
                                                             const Flown* flown);

/// Coverage in true areas.
/// @param cells  The ledger's view, of which abandoned and uncertain are kept.
CoverageFigures sweep_coverage(const CoverageFigures& cells, const planner::SweepFigures& sweep,
                               const planner::SprayedAreas& areas);

}  // namespace furrow::app
