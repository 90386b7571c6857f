#pragma once

#include "core/expected.hpp"
#include "planner/plan_error.hpp"
#include "planner/returns/problem.hpp"

namespace furrow::planner {

/// The simple plan: every return on the field edge where the station is, that is at the end of a
/// strip nearer to the station, as few returns as tank and pack allow. Where none of these ends is
/// within reach, the furthest cell stands in for it.
///
/// @error  tank_too_small, out_of_reach  See `infeasibility`.
///
/// Source: Wang et al. 2017, section 2.2.
Expected<ReturnPlan, PlanError> simple_plan(const ReturnProblem& problem);

}  // namespace furrow::planner
