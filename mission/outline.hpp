#pragma once

#include "mission/reader.hpp"
#include "mission/scenario.hpp"

namespace furrow::mission {

/// Reads the land of the section `field` and its place on the globe: from a file, or from rings.
///
/// Rings must be sound polygons; those of a file may cross themselves as far as that can be mended.
/// Holes may touch or cross each other and the boundary, and are made one or cut there; a hole
/// outside is left out. An area that the file states is kept, and warned of where the land differs
/// by more than a thousandth. What was mended or left out is warned of, with the place.
void read_outline(const Section& field, Scenario& out);

}  // namespace furrow::mission
