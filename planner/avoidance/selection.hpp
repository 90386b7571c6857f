#pragma once
// Which option to take for each crowd: the problem, its cost, and its optimum where that is cheap.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace furrow::planner {

/// What one option costs while all others fly straight.
struct OptionCost {
  double extra_m;   ///< Longer than the straight pass.
  double wrong_m2;  ///< Missed and repeated.
};

/// What two options cost more than each alone: ground that both touch.
struct Interplay {
  std::size_t first, second;     ///< Crowds, first < second.
  std::vector<double> wrong_m2;  ///< By option of the first, then of the second.
};

/// One option of each crowd is to be chosen.
struct SelectionProblem {
  std::vector<std::vector<OptionCost>> crowds;    ///< In the order flown; each at least one option.
  std::vector<Interplay> interplays;              ///< At most one for two crowds.
  double straight_m;                              ///< Length of all passes, > 0.
  double planned_m2;                              ///< Area of all passes, > 0.
  double length_weight = 0.5, area_weight = 0.5;  ///< >= 0.
};

/// Number of the option chosen for each crowd.
using Selection = std::vector<std::uint16_t>;

/// Weighted sum of normalised length and normalised wrong area:
///
///     w_L (b + extra) / b + w_A wrong / planned
double fitness(const SelectionProblem& problem, const Selection& selection);

/// Each crowd's own best option, as if there were no interplay.
Selection greedy_selection(const SelectionProblem& problem);

/// The selection of least fitness. Crowds that interplay, directly or through others, are
/// enumerated together; along a chain by dynamic programming.
///
/// @return  Nothing where such a group is no chain and has more than `most` selections.
std::optional<Selection> exact_selection(const SelectionProblem& problem, double most = 1 << 20);

}  // namespace furrow::planner
