#pragma once

#include "app/results/flown.hpp"
#include "app/results/result.hpp"
#include "core/field.hpp"
#include "planner/coverage/route.hpp"

#include <span>

namespace furrow::app {

/// What the swaths wetted when each pass over a cell was shifted sideways by its true offset.
///
/// Across the strips it is interval arithmetic, row of cells by row of cells; along them a cell's
/// offset stands for the whole cell. What lies outside the field is sampled every sixteenth of a
/// swath.
///
/// @param passes              Over cells of `route`.
/// @param work_direction_deg  Of the strips, clockwise from north.
FootprintFigures footprint(const Field& field, const planner::Route& route,
                           std::span<const Pass> passes, double work_direction_deg);

}  // namespace furrow::app
