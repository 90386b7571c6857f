#pragma once

#include "planner/routes/route_search.hpp"

#include <cstdint>

namespace furrow::planner {

/// A* over a lattice in the box, as fine as half the budget allows, with steps to all 26
/// neighbours; then pulled straight, fitted with a curve, and settled for the rest of the budget.
/// Where the lattice has no way, the straight line is settled instead.
///
/// `history` holds the cost after fitting and at the end.
/// Source: Hart, Nilsson, Raphael 1968.
RouteSearch lattice_route(const Scene& scene, std::uint64_t evaluations, std::uint64_t seed);

}  // namespace furrow::planner
