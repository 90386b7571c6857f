#pragma once

#include "planner/routes/route_search.hpp"

#include <cstdint>

namespace furrow::planner {

enum class SamplingPlanner { rrt_star, bit_star };

/// OMPL's informed planners for the shortest clear polyline, pulled straight and fitted with a
/// curve at the end; all looked-up places are counted. `history` holds the final cost. Where the
/// planner finds no polyline, the result is the straight line's.
///
/// OMPL draws from one seed sequence for the whole process, which is set anew here: calls repeat as
/// long as no two run at once.
///
/// Source: Karaman, Frazzoli 2011, IJRR 30(7), 846-894 (RRT*); Gammell, Srinivasa, Barfoot 2015,
/// ICRA, 3067-3074 (BIT*).
RouteSearch sampled_route(const Scene& scene, SamplingPlanner planner, std::uint64_t evaluations,
                          std::uint64_t seed);

}  // namespace furrow::planner
