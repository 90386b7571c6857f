#pragma once

#include "planner/coverage/swath/strips.hpp"

#include <vector>

namespace furrow::planner {

/// A strip on the ground, in the plane of the field.
struct GroundStrip {
  PointM a, b;
  double half_width_m;
};

/// Strips that lie side by side and are flown together, to and fro, in this order or its reverse.
/// A group that must be flown as it stands (a headland round) is `fixed`.
struct StripGroup {
  std::vector<GroundStrip> strips;
  bool fixed = false;
};

/// Groups the chords of a sweep: chords of neighbouring rows belong together while each has just
/// the other beside it and no end jumps by more than four swaths to another edge. Chords between
/// the same two edges are therefore always together.
///
/// Source: boustrophedon decomposition, Choset 2000, on rows instead of the continuum.
std::vector<StripGroup> strip_groups(const Sweep& sweep, double swath_m);

}  // namespace furrow::planner
