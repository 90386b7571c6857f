#pragma once

#include "planner/coverage/swath/areas.hpp"
#include "planner/coverage/swath/part_plan.hpp"

#include <vector>

namespace furrow::planner {

/// Strips in the order flown as runs of the open valve: those that follow each other without a gap
/// are sprayed in one run.
std::vector<SprayedRun> runs_of(const std::vector<OrderedStrip>& strips);

/// The cheapest of the first four `plans` when finished. Finishing turns rows into the plan of a
/// part: in `cover_all` it adds strips along edges that the rows leave ragged and joins corners;
/// then it keeps ways clear of corners. What the rows miss is measured in parallel, with one result
/// however many threads there are.
///
/// @param plans   At least one, the cheapest first.
/// @param flight  Where strips may lie.
/// @param land    What the plan is to cover, as far as strips in `flight` reach it.
PartPlan cheapest_finished(std::vector<PartPlan> plans, const LandPart& flight,
                           const LandParts& land, const InsidePaths& paths, const PlanRule& rule);

}  // namespace furrow::planner
