#pragma once

#include "app/results/flown.hpp"
#include "app/results/result.hpp"
#include "core/field.hpp"
#include "planner/coverage/route.hpp"

#include <span>

namespace furrow::app {

/// What the swaths wetted when each pass over a cell was shifted sideways by its true offset.
///
/// Along a strip, a cell's offset stands for the whole cell. Where strips are sprayed from centre
/// to centre, all cells lie on one lattice and it is interval arithmetic across the strips, row of
/// cells by row of cells; what lies outside the field is sampled every sixteenth of a swath. Strips
/// that are sprayed from end to end may lie in any direction: all is sampled, every eighth of a
/// swath or at four million places; areas are good to about a sample's area per sample on their
/// edges, and missed is what no strip wetted of the whole field less its holes, not of its cells.
///
/// @param passes              Over cells of `route`.
/// @param work_direction_deg  Of the strips, clockwise from north.
FootprintFigures footprint(const Field& field, const planner::Route& route,
                           std::span<const Pass> passes, double work_direction_deg);

}  // namespace furrow::app
