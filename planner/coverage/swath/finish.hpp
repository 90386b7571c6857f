#pragma once

#include "planner/coverage/swath/areas.hpp"
#include "planner/coverage/swath/part_plan.hpp"

#include <vector>

namespace furrow::planner {

/// Strips in the order flown as runs of the open valve: those that follow each other without a gap
/// are sprayed in one run.
std::vector<SprayedRun> runs_of(const std::vector<OrderedStrip>& strips);

/// What turns rows into the plan of a part: in `cover_all` strips along edges that the rows leave
/// ragged and joined corners, then ways that keep clear of corners. The cost of the plan is then
/// that of all of it.
///
/// @param flight  Where strips may lie.
/// @param land    What the plan is to cover, as far as strips in `flight` reach it.
void finish(PartPlan& plan, const LandPart& flight, const LandParts& land, const InsidePaths& paths,
            const PlanRule& rule);

/// The plan that is cheapest when finished, of the first few of `plans`, which are the cheapest
/// before. What their rows miss is measured in parallel, to the same result on any machine.
/// @param plans  At least one, cheapest first.
PartPlan cheapest_finished(std::vector<PartPlan> plans, const LandPart& flight,
                           const LandParts& land, const InsidePaths& paths, const PlanRule& rule);

}  // namespace furrow::planner
