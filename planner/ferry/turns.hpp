#pragma once

#include "core/corner.hpp"
#include "core/vehicle.hpp"

namespace furrow::planner {

/// How much longer a corner takes than flight through it at ferry speed [s]: braking to the speed
/// of its arc, the arc, and gathering speed again. Arcs are those of `corner_arc` with half a swath
/// to cut, flown with nine tenths of the planned acceleration across.
/// @param before, after  Where the legs begin and end; a leg of no length is no corner.
double turn_loss_s(FieldPoint before, FieldPoint at, FieldPoint after, Corner corner,
                   const Vehicle& vehicle);

/// How much longer it takes to gather ferry speed from rest, or to come to rest from it, than to
/// fly the same length at it [s].
double rest_loss_s(const Vehicle& vehicle);

}  // namespace furrow::planner
