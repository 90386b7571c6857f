#pragma once

#include "planner/fleet/problem.hpp"
#include "planner/fleet/queue_clock.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace furrow::planner::fleet {

struct FleetSolveSettings {
  std::uint64_t budget = 6'000'000;  ///< Sorties that the queue clock flies, about.
  std::uint64_t seed = 1;
  std::uint32_t runs = 3;              ///< Of annealing, from the best starts; >= 1.
  bool is_cool = false;                ///< Takes plans of many sorties to settle far slower.
  std::vector<FleetSorties> starts{};  ///< Begins with these too, where tank and pack carry them.
};

struct FleetSolution {
  FleetSorties sorties;
  Finish finish;
  double till_empty_s, simple_s;  ///< Makespans of the plans it started from; infinite if none.
  std::uint64_t evaluations;      ///< Plans flown.
};

/// Shares, return points, order and stations of a fleet together, for a short makespan, then a
/// short sum of landings.
///
/// Begins with flying till empty, the simple plan, and equal stretches of several lengths, all
/// dealt out to whoever is ready first; with several stations, also with the solved plans of each
/// station's aircraft on a stretch of their own; and with those that the settings give. Improves
/// the best by simulated annealing over `CutPlan`, each plan flown by the queue clock; never worse
/// than any that it began with. Deterministic: the budget counts work.
///
/// @return  Nothing if no start reaches the whole path.
///
/// Source: Kirkpatrick, Gelatt, Vecchi 1983, Science 220, 671-680 (annealing).
std::optional<FleetSolution> solved(const FleetProblem& problem,
                                    const FleetSolveSettings& settings = {});

}  // namespace furrow::planner::fleet
