#pragma once

#include "planner/returns/battery_bound.hpp"
#include "planner/returns/legs.hpp"

#include <cstdint>
#include <optional>

namespace furrow::planner {

/// What a search for plans better than a known one has shown.
struct SearchOutcome {
  std::optional<Returns> better;  ///< The best plan found, if better than the cutoff.
  double cost_s;                  ///< Its non-spray time; the cutoff if none was found.
  double lower_bound_s;           ///< No plan within the bound's scope has less.
  bool finished;                  ///< `cost_s` is optimal.
};

/// The plan that follows the bound greedily: one leg after the other, each the most promising.
SearchOutcome dive(const Legs& legs, const BatteryBound& bound, double cutoff_s,
                   std::uint64_t& work_left);

/// Best-first search over partial plans, each ending with a landing: cost so far, exact charge, and
/// the bound as the completion's estimate. Ends with the proven optimum, or after `work_left` legs,
/// or after a million partial plans. Source: Hart, Nilsson, Raphael 1968 (A*).
SearchOutcome best_first(const Legs& legs, const BatteryBound& bound, double cutoff_s,
                         std::uint64_t& work_left);

}  // namespace furrow::planner
