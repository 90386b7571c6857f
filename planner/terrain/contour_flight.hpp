#pragma once

#include "planner/terrain/surface.hpp"

#include <vector>

namespace furrow::planner {

/// How an aircraft follows the ground while it sprays; all > 0.
struct ContourRule {
  Length height;         ///< Above the ground, kept all along.
  Speed spray_speed;     ///< Along the ground, where the slope allows it.
  Speed slowest;         ///< Below it, spraying is not possible; <= spray_speed.
  Speed climb, descent;  ///< Most vertical speed upwards and downwards.
};

/// A place on a strip: from here on, as fast as said until the next.
struct ContourPoint {
  Length along;     ///< From the strip's start.
  Length altitude;  ///< Above the datum: the ground and the height kept.
  Speed speed;      ///< Along the ground; 0 at the last.
};

struct ContourFlight {
  std::vector<ContourPoint> points;  ///< From start to end of the strip, two or more.
  Seconds duration;
  Length too_steep;  ///< Of the strip where the slope asks for less than `slowest`: there the
                     ///< aircraft flies at `slowest`, and the height is not kept.
};

/// The strip from `from` to `to` at a constant height above the surface. Where the slope would ask
/// for more vertical speed than the aircraft has, it slows down. Changes of speed are taken as
/// sudden.
///
/// Points lie where the strip crosses the rows and columns of the raster and halfway between; the
/// slope within a piece is that of its ends.
/// @pre from and to differ
ContourFlight contour_flight(const Surface& surface, FieldPoint from, FieldPoint to,
                             const ContourRule& rule);

}  // namespace furrow::planner
