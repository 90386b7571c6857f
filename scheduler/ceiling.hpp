#pragma once

#include "planner/plan_error.hpp"
#include "scheduler/fleet_plan.hpp"

#include <optional>
#include <span>

namespace furrow::scheduler {

/// The first ferry that flies above the ceiling of the terrain in the highest layer, of all those
/// between each aircraft's cells and any station, and from its home. Nothing where there is no
/// ceiling or all ferries are below it.
/// @return  ceiling_too_low.
std::optional<planner::PlanError> ceiling_fault(const FleetPlan& plan,
                                                std::span<const Station> stations);

}  // namespace furrow::scheduler
