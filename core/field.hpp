#pragma once

#include "core/geometry.hpp"

#include <string>
#include <vector>

namespace furrow {

/// A closed polygon without its repeated first vertex; either orientation; at least 3 vertices.
using Ring = std::vector<FieldPoint>;

/// Whether `p` lies inside `ring`. Points on an edge are either.
bool contains(const Ring& ring, FieldPoint p);

/// Distance from `p` to the nearest point of the ring's edges, from inside or outside.
Length edge_distance(const Ring& ring, FieldPoint p);

/// Something that nobody sprays or flies over, known before take-off: round (a tree, a mast), or of
/// any outline (a pond, a house, a zone closed to flight).
struct Obstacle {
  std::string id;
  FieldPoint center;  ///< Of the smallest box around an outline.
  Length radius;      ///< Of a circle that holds it.
  Ring outline{};     ///< Empty: round.
};

/// An obstacle of that outline. @pre At least 3 vertices.
Obstacle outlined(std::string id, Ring outline);

/// How deep `p` lies inside the obstacle; negative outside.
Length depth_in(const Obstacle& obstacle, FieldPoint p);

/// The land to spray, in the field frame.
struct Field {
  Ring boundary;
  std::vector<Ring> holes;  ///< Within the boundary, which they may touch, and apart.
  std::vector<Obstacle> obstacles;
};

}  // namespace furrow
