#pragma once

#include "planner/coverage/swath/edge_grid.hpp"

namespace furrow::planner {

/// `path`, its bends moved away from the corners that they touch, so that a path with rounded bends
/// stays on the land too.
///
/// An arc that leaves both legs c before a bend of angle q passes the bend c tan(q / 4) inside. The
/// bend moves so far outwards where the land leaves room. Where it does not, two places close to
/// the bend on its legs make the arc tight.
///
/// @param cut_m  c, of bends whose legs are at least twice as long; of others half the shorter leg.
PathM clear_of_corners(const PathM& path, const EdgeGrid& edges, double cut_m);

}  // namespace furrow::planner
