#pragma once

#include "planner/plan_error.hpp"
#include "planner/returns/problem.hpp"

#include <optional>
#include <span>

namespace furrow::planner {

/// What a choice of return points costs.
///
/// A pack is swapped when, and only when, the charge left (reserve kept) cannot carry the next
/// sortie completely, its way home included. The tank is filled for the next sortie only.
/// Filling and swapping run side by side. The way out of the first sortie and the way home of the
/// last count in the flight time and in the battery, not in the non-spray time.
///
/// @param returns  Strictly rising, above the first cell and below the last. They need not be
/// feasible: a sortie longer
///                 than a tank is filled for in proportion.
///
/// Source: Wang et al. 2017, equations (7) and (9).
ReturnPlan evaluated(const ReturnProblem& problem, const Returns& returns);

/// The same where sorties end at different stations.
/// @param landings  By sortie, returns.size() + 1 of them: the problem of the one share at the
///                  station where it ends.
ReturnPlan evaluated(std::span<const ReturnProblem* const> landings, const Returns& returns);

/// The same with packs as aircraft swap them: when the charge left is less than `wanted_pack_s`.
/// @param lost_s  By sortie: what it takes of its pack beyond what the problems count.
ReturnPlan evaluated_as_flown(std::span<const ReturnProblem* const> landings,
                              const Returns& returns, std::span<const double> lost_s);

/// Whether every sortie of the plan stays within one tank and one pack (reserve kept).
bool is_feasible(const ReturnProblem& problem, const ReturnPlan& plan);

/// Why no choice of return points is feasible, if so: some cell cannot be reached from the station,
/// sprayed after the cell before it, and left for the station, on one tank and one pack.
///
/// Exact for aircraft that ferry at least as fast as they spray.
std::optional<PlanError> infeasibility(const ReturnProblem& problem);

/// Condition (1): whether the simple plan with as many returns as the unplanned one is optimal.
/// Source: Wang et al. 2017, equation (1).
bool simple_plan_suffices(const ReturnProblem& problem, const ReturnPlan& unplanned,
                          const ReturnPlan& simple);

}  // namespace furrow::planner
