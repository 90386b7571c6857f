#pragma once

#include "planner/routes/population.hpp"

#include <cstdint>

namespace furrow::planner {

/// The cheapest route that several rounds of mutation pass. A round looks at three way points in a
/// row, from a random one on. Those of them that lie under the clearance, in a volume or outside
/// are mutated until they are clear (at most 20 times each); where all are clear, a random way
/// point is mutated and remembered. Then one of the remembered, or any if there is none, is
/// deleted, unless it is the last. The route is judged before and after the deletion: two
/// evaluations and 3 to 63 looked-up places a round.
///
/// The route that comes in is not among the candidates: a mutation may lose.
/// @pre one gene or more; rounds >= 1
/// Source: Huang et al., heuristic multiple mutation.
Individual heuristic_mutation(const Genes& genes, std::uint32_t rounds, RouteJudge& judge,
                              Random& random);

/// The plain counterpart: one random way point moved. One evaluation.
Individual random_mutation(const Genes& genes, RouteJudge& judge, Random& random);

}  // namespace furrow::planner
