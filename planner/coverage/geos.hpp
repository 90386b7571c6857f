#pragma once
// The only door to GEOS: plain rings in, plain rings out.

#include "planner/coverage/plane.hpp"

#include <optional>
#include <string>
#include <vector>

namespace furrow::planner {

/// What makes a polygon invalid.
struct Defect {
  std::string why;
  PointM at;
};

/// What makes `part` no valid polygon, nothing if it is one; its rings may run either way round.
std::optional<Defect> defect_in(const LandPart& part);

/// "WHY at (X, Y) m", with `origin` added, so that it reads in the operator's frame.
std::string text(const Defect& defect, PointM origin);

/// The area that `ring` encloses an odd number of times, as valid parts.
LandParts even_odd(const RingM& ring);

/// All that any of `parts` contains; parts may overlap and must each be valid.
LandParts united(const LandParts& parts);

/// What `land` contains and `taken` does not.
LandParts subtracted(const LandParts& land, const LandParts& taken);

/// Land moved outwards by `distance_m`, inwards if negative, with mitred corners: no place of an
/// inset is nearer to the old edge than the distance.
LandParts offset(const LandParts& land, double distance_m);

/// A polyline of at least two places widened by `half_width_m` to each side: square ends, round
/// corners.
LandParts widened(const PathM& path, double half_width_m);

/// The faces between `lines`, which may cross.
LandParts faces(const std::vector<PathM>& lines);

/// A place well inside `part`.
PointM inner_place(const LandPart& part);

/// Length of `paths` over no part of `land`.
double length_outside_m(const std::vector<PathM>& paths, const LandParts& land);

}  // namespace furrow::planner
