#pragma once
// Plain geometry of the land: enough to say what lay outside it.

#include "core/field.hpp"

namespace furrow::app {

/// Area inside `ring`, whatever its orientation.
Area area(const Ring& ring);

/// Area inside the boundary and outside the holes.
Area area(const Field& field);

/// Whether `p` is inside the boundary and outside the holes. Points on an edge are either.
bool contains(const Field& field, FieldPoint p);

/// How much of the straight way from `a` to `b` is outside the field. Holes are no land either, but
/// flying over them is: they count as inside.
Length length_outside(const Field& field, FieldPoint a, FieldPoint b);

}  // namespace furrow::app
