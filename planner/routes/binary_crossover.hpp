#pragma once

#include "planner/routes/population.hpp"

#include <utility>

namespace furrow::planner {

/// Two children by simulated binary crossover: each coordinate of genes that both parents have is
/// drawn to either side of the parents' values, within the box; further genes stay.
///
/// @param eta  Distribution index, > 0: the larger, the closer to the parents.
/// Source: Deb, Agrawal 1995, Complex Systems 9(2), 115-148.
std::pair<Genes, Genes> binary_crossover(const Genes& a, const Genes& b, const Scene& scene,
                                         double eta, Random& random);

}  // namespace furrow::planner
