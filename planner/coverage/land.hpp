#pragma once

#include "core/expected.hpp"
#include "core/field.hpp"
#include "planner/plan_error.hpp"

#include <vector>

namespace furrow::planner {

/// The rings that enclose the land to spray: boundary and holes, drawn in by `margin`.
///
/// @param margin  Inset from boundary and holes, >= 0, with mitred corners. Obstacles are left
///                out: they are round, and keep their radius.
///
/// Holes may touch, cross each other or the boundary, or lie outside.
///
/// @return  Rings that do not cross; a place is land if an odd number of them enclose it. Empty
///          where the margin leaves nothing.
/// @error   field_invalid  A ring crosses itself, encloses no area or is not finite;
///          `detail` names the place.
Expected<std::vector<Ring>, PlanError> land_rings(const Field& field, Length margin);

}  // namespace furrow::planner
