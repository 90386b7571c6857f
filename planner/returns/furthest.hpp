#pragma once

#include "planner/returns/problem.hpp"

namespace furrow::planner {

/// Whether one tank and one pack carry a sortie from cell `first` to cell `last`.
bool carries(const ReturnProblem& problem, std::uint32_t first, std::uint32_t last);

/// The last cell that a sortie from cell `first` can spray, or `first` if there is none.
std::uint32_t furthest_from(const ReturnProblem& problem, std::uint32_t first);

}  // namespace furrow::planner
