#pragma once

#include "planner/avoidance/selection.hpp"

namespace furrow::planner {

struct GeneticSettings {
  std::uint32_t population = 60;   ///< >= 2.
  std::uint32_t iterations = 200;  ///< Generations at most.
  double target_fitness = 0;       ///< Stops as soon as this is reached.
  std::uint64_t seed = 0;
};

struct GeneticResult {
  Selection best;
  double fitness;
  std::uint32_t iterations;  ///< Generations made.
};

/// A selection of small fitness: parents by tournaments of three, children by uniform crossover,
/// each gene redrawn with a chance of one per child, the two best live on.
///
/// @param starts  First members of the population; the others are drawn at random.
/// Time O(iterations population (crowds + interplays)).
GeneticResult genetic_selection(const SelectionProblem& problem, const GeneticSettings& settings,
                                const std::vector<Selection>& starts = {});

}  // namespace furrow::planner
