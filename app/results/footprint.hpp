#pragma once

#include "app/results/flown.hpp"
#include "app/results/result.hpp"
#include "core/field.hpp"
#include "planner/coverage/route.hpp"

#include <span>

namespace furrow::app {

/// What the swaths wetted when each pass over a cell was shifted sideways by its true offset.
///
/// Along a strip, a cell's offset stands for the whole cell. All cells lie on one lattice, so it is
/// interval arithmetic across the strips, row of cells by row of cells; what lies outside the field
/// is sampled every sixteenth of a swath.
///
/// @param route               Sprayed from centre to centre of its cells.
/// @param passes              Over cells of `route`.
/// @param work_direction_deg  Of the strips, clockwise from north.
FootprintFigures footprint(const Field& field, const planner::Route& route,
                           std::span<const Pass> passes, double work_direction_deg);

/// The same of a swept field, whose tracks were followed exactly.
FootprintFigures footprint(const planner::SprayedAreas& areas);

}  // namespace furrow::app
