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

/// A round thing to keep clear of, known before take-off.
struct Obstacle {
  std::string id;
  FieldPoint center;
  Length radius;
};

/// The land to spray, in the field frame.
struct Field {
  Ring boundary;
  std::vector<Ring> holes;  ///< Inside the boundary, disjoint from each other.
  std::vector<Obstacle> obstacles;
};

}  // namespace furrow
