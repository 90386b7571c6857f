#pragma once

#include "planner/routes/route_search.hpp"

#include <cstdint>

namespace furrow::planner {

enum class ParentSelection { mixed, roulette };
enum class Crossover { asymmetric_mapping, simulated_binary };
enum class Mutation { heuristic_multiple, random };

struct EvolutionSettings {
  ParentSelection selection = ParentSelection::mixed;
  Crossover crossover = Crossover::asymmetric_mapping;
  Mutation mutation = Mutation::heuristic_multiple;
  std::uint32_t population = 40;  ///< >= 2
  std::uint32_t chromosome = 9;   ///< Genes at first, start and goal counted: 3 to 32.
  double crossover_rate = 0.6;    ///< Share of pairs crossed.
  double mutation_rate = 0.9;     ///< Share of children mutated.
  double tournament_share = 0.5;  ///< alpha
  double mapping_share = 0.5;     ///< beta: by mapping until this share of the budget is spent.
  std::uint32_t intervals = 64;   ///< m
  std::uint32_t mutation_rounds = 3;
  double eta = 2;  ///< Of simulated binary crossover.
};

/// The improved genetic algorithm of the source, with each of its operators exchangeable for the
/// plain one. The best individual always survives. Ends when `evaluations` are spent; the last
/// generation is finished, so a little more may be.
///
/// @pre evaluations >= population
/// Source: Huang, Tian, Qiao, Wang, Su, "UAV path planning based on improved genetic algorithm".
RouteSearch evolved_route(const Scene& scene, const EvolutionSettings& settings,
                          std::uint64_t evaluations, std::uint64_t seed);

/// The same loop with roulette, simulated binary crossover and random mutation.
EvolutionSettings plain_evolution(EvolutionSettings settings = {});

}  // namespace furrow::planner
