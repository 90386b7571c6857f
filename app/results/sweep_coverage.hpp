#pragma once

#include "app/results/flown.hpp"
#include "app/results/result.hpp"
#include "planner/coverage/swath/swath.hpp"

#include <vector>

namespace furrow::app {

/// Obstacles met in flight, in the order first told of.
std::vector<SeenObstacle> seen_obstacles(const std::vector<Envelope>& log);

/// How they were flown around.
MetFigures met_figures(const std::vector<Envelope>& log);

/// The field with the obstacles that were met: nothing is missed there.
Field known_field(const MissionRecord& record);

/// True areas of a swept field, from the union of footprints: of the strips as planned, or of the
/// tracks as flown. Ground under an obstacle is not missed, whether the plan knew it or not.
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
