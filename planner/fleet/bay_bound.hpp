#pragma once

#include "planner/fleet/problem.hpp"

#include <cstdint>

namespace furrow::planner::fleet {

/// Prices are searched for so often with time in about so many slots, then with finer ones.
struct BayBoundSettings {
  std::uint32_t slots = 120, evaluations = 500;
  std::uint32_t fine_slots = 500, fine_evaluations = 150;
};

/// No plan ends earlier, for the bays could not serve it: or `from_s` where that is not shown.
///
/// Let sorties have prices mu by their flight times and nu by what they spray, bays prices lambda
/// by the time of day, for services and for filling. In any plan of makespan T, the sorties
/// together cost at least M, the cheapest split of the path and nu times its length; every aircraft
/// earns at most U by its sorties less its time in bays; every bay earns at most B, by all its
/// time. So M <= aircraft U + bays B for all prices, and prices that break it prove that there is
/// no such plan. They are searched for by Shor's r-algorithm, T rising whenever one is refuted.
///
/// No search where there is a bay for every aircraft, nor with slots so fine that the path takes
/// more than 200 000 cells of half a slot. The aircraft are taken for as fast as the fastest, bays
/// for as near as the nearest. Source: Geoffrion 1974, Math. Prog. Study 2, 82-114 (Lagrangian
/// relaxation).
///
/// @param from_s  A bound that is known, > 0: the search for prices starts there.
double bay_bound_s(const FleetProblem& problem, double from_s,
                   const BayBoundSettings& settings = {});

}  // namespace furrow::planner::fleet
