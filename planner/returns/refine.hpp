#pragma once

#include "planner/returns/gsa_returns.hpp"
#include "planner/returns/objective.hpp"
#include "planner/returns/problem.hpp"

#include <cstdint>

namespace furrow::planner {

/// Improves returns until no move of the neighbourhood does. Two kinds of moves take turns:
///
///  - all returns at once, each within a window around it, and any added or left out at strip ends,
///    by dynamic programming over the non-spray time (`best_among`), windows from wide and coarse
///    to narrow and fine;
///  - one return, or two or three neighbours by the same number of cells, and one return left out,
///    by the whole objective, extra cost included.
///
/// Deterministic; the result is never worse than `start` and, where `start` is feasible, feasible.
/// Of the order of 0.1 s for 17 000 cells and 14 returns.
///
/// @param start  Strictly rising, below the last cell.
/// @param moves  At most so many moves of the second kind are judged.
FoundReturns refined(const ReturnProblem& problem, const Returns& start, ReturnObjective& objective,
                     std::uint64_t moves = 20'000);

}  // namespace furrow::planner
