#pragma once

#include "planner/routes/route_search.hpp"

#include <cstdint>

namespace furrow::planner {

struct AntSettings {
  std::uint32_t ants = 40;     ///< Per generation, >= 1.
  std::uint32_t layers = 7;    ///< Way points of each ant, 1 to 30.
  std::uint32_t across = 15;   ///< Places of a layer sideways, >= 2 ...
  std::uint32_t upwards = 8;   ///< ... and upwards, >= 2.
  double nearness_power = 20;  ///< Of 1 / length of the step and the rest of the way.
  double evaporation = 0.1;    ///< Share lost in a generation.
  double fresh_share = 0.05;   ///< Of choices made without pheromone.
};

/// Ant colony: layers of places across the way from start to goal; each ant chooses one place per
/// layer by the pheromone of the step times its nearness to the power given; the best of each
/// generation and the best of all lay pheromone on their steps. The curve through the chosen places
/// is what is judged.
///
/// Source: Dorigo, Maniezzo, Colorni 1996, IEEE Trans. SMC-B 26(1), 29-41; elitist variant.
RouteSearch ant_route(const Scene& scene, const AntSettings& settings, std::uint64_t evaluations,
                      std::uint64_t seed);

}  // namespace furrow::planner
