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

}  // namespace furrow::app
