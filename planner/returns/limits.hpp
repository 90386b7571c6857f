#pragma once

#include "planner/returns/problem.hpp"

namespace furrow::planner {

/// What one sortie may take, widened by a billionth: sums of metres and seconds that meet a limit
/// exactly must not fail it by rounding. Every solver compares against these.
struct Limits {
  double tank_m;  ///< D_max.
  double pack_s;  ///< Usable endurance of one pack, less what the problem keeps.
};

constexpr Limits limits_of(const ReturnProblem& problem) {
  constexpr double widened = 1.0 + 1e-9;
  return {.tank_m = widened * tank_range(problem.vehicle).base(),
          .pack_s = widened * (usable_endurance(problem.vehicle).base() - problem.kept_s)};
}

}  // namespace furrow::planner
