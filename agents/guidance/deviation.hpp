#pragma once

#include "agents/guidance/path.hpp"

namespace furrow::agents {

/// How far a position is along a segment, and how far beside it.
struct Deviation {
  double along_m;  ///< Distance along the path of the nearest point.
  double cross_m;  ///< Cross-track distance d, right of the flown direction positive.
};

/// The deviation of a fix from the line through the segment's key points R1 and R2, or from its
/// arc.
/// Source: Wang et al. 2017, section 2.4.
Deviation deviation(const Segment& segment, Xy fix_m);

/// Signed distance of a point from the line through `from` and `to`, right positive; 0 where they
/// coincide.
double cross_track_m(Xy from_m, Xy to_m, Xy point_m);

}  // namespace furrow::agents
