#pragma once

#include "planner/coverage/swath/strips.hpp"

#include <vector>

namespace furrow::planner {

/// A strip on the ground, in the plane of the field.
struct GroundStrip {
  PointM a, b;
  double half_width_m;
};

/// How the strips of a group follow each other.
enum class Flown {
  to_and_fro,  ///< Side by side: each from the other end than the one before, from any corner.
  in_a_chain,  ///< End to end, from either end of the chain.
  as_it_is,    ///< End to end, in this sense only.
};

/// Strips that are flown together, in this order or its reverse.
struct StripGroup {
  std::vector<GroundStrip> strips;
  Flown flown = Flown::to_and_fro;
};

/// Groups the chords of a sweep: chords of neighbouring rows belong together while each has just
/// the other beside it and no end jumps by more than four swaths to another edge. Chords between
/// the same two edges are therefore always together.
///
/// Source: boustrophedon decomposition, Choset 2000, on rows instead of the continuum.
std::vector<StripGroup> strip_groups(const Sweep& sweep, double swath_m);

}  // namespace furrow::planner
