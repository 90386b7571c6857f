#pragma once

#include "core/expected.hpp"
#include "planner/plan_error.hpp"
#include "planner/returns/exact.hpp"
#include "planner/returns/problem.hpp"

namespace furrow::planner {

/// What the best plan costs that may return anywhere along the strips, not at cells only.
struct ContinuousBracket {
  ExactResult upper;  ///< A plan that can be flown: it returns after whole cells.
  double lower_s;     ///< No plan has less non-spray time, wherever it returns.

  /// First way out, route, non-spray time and last way home: all that is flown and waited, above
  /// and below, seconds.
  double mission_upper_s, mission_lower_s;
  double gap() const { return (mission_upper_s - mission_lower_s) / mission_upper_s; }
};

/// Brackets the optimum over all places of return between the exact plan on the cells and the exact
/// optimum of a relaxation on the same cells. Short cells give a narrow bracket.
///
/// The relaxation: let c be the length of the longest cell, c_i of cell i, and s_i and back_i how
/// far its two ends are from the station. Tanks last c longer; a return after cell i flies s_i +
/// back_i - c_i or, if less, back_i + out_i less the ferry that it replaces; a filling costs c's
/// worth less; packs last for ever.
///
/// Its optimum bounds every plan. Move each return x, which lies in some cell i, to the end e_i of
/// the cell, e_i - c_i < x <= e_i; keep the last of those in one cell; drop those in the first and
/// in the last cell. Then, for a sortie that was flown from a to b and is kept,
///  - it sprays e_b - e_a <= (b + c) - a, so the longer tank carries it. So it does where returns
///    were dropped: in the first cell, the first sortie grows by at most c at its beginning, in the
///    last cell the last one by at most c at its end, and within a cell, the sorties before and
///    after one cell meet at its end;
///  - its filling costs at most c's worth more than it did, which the relaxation takes off;
///  - its return flies no further: for x = e_i it flies just that; else to x and back, and x, at
///    t from one end of the cell, is at least s_i - t and back_i - (c_i - t) away from the station,
///    so at least half the sum of both.
/// Dropped returns had costs that are not negative, for within a cell nothing is replaced.
///
/// Where packs do not last, the bracket also holds what swaps and short packs cost.
///
/// @pre Level land.
/// @error  tank_too_small, out_of_reach  See `infeasibility`.
///
/// Time of `exact_plan` plus O(cells).
Expected<ContinuousBracket, PlanError> continuous_bracket(const ReturnProblem& problem,
                                                          const ExactSettings& settings = {});

/// The same, bounded from below on cells of at most a quarter of a metre: narrow also where the
/// plan returns after long cells.
/// @param route    Sprayed from end to end.
/// @param problem  Of cells of `route`.
Expected<ContinuousBracket, PlanError> continuous_bracket(const Route& route,
                                                          const ReturnProblem& problem,
                                                          const ExactSettings& settings = {});

}  // namespace furrow::planner
