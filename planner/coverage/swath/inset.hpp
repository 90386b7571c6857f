#pragma once

#include "core/expected.hpp"
#include "core/field.hpp"
#include "planner/coverage/plane.hpp"
#include "planner/plan_error.hpp"

namespace furrow::planner {

/// What is to be sprayed and where the aircraft may be, around a common origin.
struct FieldLand {
  PointM origin;     ///< Added to any place below, gives it in the field frame.
  LandParts land;    ///< To be sprayed: the boundary less holes and obstacles.
  LandParts flight;  ///< Where flight is allowed: `land` drawn in. Parts do not touch.
  LandParts taken;   ///< Holes and obstacles, drawn out as far as flight keeps away from them.
};

/// Cleans the rings of `field` and draws it in.
///
/// Repeated vertices, spikes without width and rings in either orientation are mended, as are holes
/// that touch, overlap each other or cross the boundary. A ring that encloses ground ambiguously
/// (by more than 1e-6 of its area) is refused.
///
/// @param margin       Least distance of flight from boundary, holes and obstacles, >= 0.
/// @param hole_buffer  Further distance from holes and obstacles, >= 0.
/// @param safety       Least distance from obstacles, whatever margin and buffer are, >= 0.
///
/// @error  field_invalid     A ring has fewer than 3 vertices, is not finite, encloses no area, or
///                           crosses itself; `detail` names the ring and the place.
/// @error  nothing_to_spray  Holes leave nothing.
/// @error  margin_too_wide   The margin leaves nothing.
Expected<FieldLand, PlanError> field_land(const Field& field, Length margin, Length hole_buffer,
                                          Length safety = {});

}  // namespace furrow::planner
