#pragma once

#include "planner/routes/population.hpp"

#include <cstddef>

namespace furrow::planner {

/// Parents for the next generation, as indices into `population` in the order picked: as many picks
/// as the population is large, a share `alpha` of them by tournaments of two, the others by a
/// roulette whose slots are as wide as 1 / cost. A pick whose genes equal those of an earlier pick
/// is dropped, so that the result is shorter than the population, and holds no route twice.
///
/// Cost: O(N log N + N^2) comparisons of whole routes, nearly all of which differ at once.
/// @pre at least one individual; 0 <= alpha <= 1
/// Source: Huang et al., mixed selection.
std::vector<std::size_t> mixed_selection(const Population& population, double alpha,
                                         Random& random);

/// The plain counterpart: as many picks by roulette as the population is large, repetitions kept.
std::vector<std::size_t> roulette_selection(const Population& population, Random& random);

}  // namespace furrow::planner
