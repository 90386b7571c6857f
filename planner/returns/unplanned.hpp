#pragma once

#include "core/expected.hpp"
#include "planner/plan_error.hpp"
#include "planner/returns/problem.hpp"

namespace furrow::planner {

/// What an unplanned aircraft counts against its tank.
enum class Counting {
  every_move,  ///< As the tank empties.
  /// As the paper's simulation: moves within strips only, and after the first sortie one less.
  /// Sorties then outlast the tank by their moves between strips; packs are not looked at.
  straight_moves,
};

/// The plan without planning: return only when the tank is empty, or when the pack would not carry
/// the next cell and the way home.
///
/// @error  tank_too_small, out_of_reach  See `infeasibility`; `every_move` only.
///
/// Source: Wang et al. 2017, section 2.2.
Expected<ReturnPlan, PlanError> unplanned_plan(const ReturnProblem& problem,
                                               Counting counting = Counting::every_move);

}  // namespace furrow::planner
