#pragma once

#include "planner/fleet/problem.hpp"

#include <cstdint>
#include <optional>

namespace furrow::planner::fleet {

struct GsaSortiesSettings {
  std::uint32_t masses = 50, iterations = 300;
  std::uint64_t seed = 1;
};

/// A fleet plan by gravity: variable n says how much of a tank sortie n sprays, 1 flies till empty.
/// The path is dealt out in order to whoever is ready first (`dealt_out`), so every point of the
/// cube is a plan; the queue clock flies it, its makespan is the objective. Two masses start as
/// flying till empty and as the simple plan: never worse than either.
///
/// @return  Nothing if flying till empty does not reach the whole path.
///
/// Source: Wang et al. 2017, section 2.3, for the search; the code of a fleet is this project's
/// own.
std::optional<FleetSorties> gsa_sorties(const FleetProblem& problem,
                                        const GsaSortiesSettings& settings = {});

}  // namespace furrow::planner::fleet
