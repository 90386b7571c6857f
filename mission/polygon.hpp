#pragma once

#include "core/field.hpp"

#include <optional>
#include <string>

namespace furrow::mission {

/// The rule of simple polygons that `ring` breaks first, with the place; nothing if it is sound.
/// Cost: O(n log n) for usual outlines, O(n^2) at worst.
std::optional<std::string> ring_fault(const Ring& ring);

/// Whether `p` lies inside `ring` and not on it.
bool is_inside(FieldPoint p, const Ring& ring);

/// Distance to the nearest point of the ring's inside or edge.
Length distance(FieldPoint p, const Ring& ring);

/// Inside `ring`, whatever its orientation.
Area area(const Ring& ring);

/// Inside the boundary and outside the holes.
Area area(const Field& field);

/// "(40, 700)": east and north in metres.
std::string text(FieldPoint p);

}  // namespace furrow::mission
