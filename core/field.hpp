#pragma once

#include "core/geometry.hpp"

#include <string>
#include <vector>

namespace furrow {

/// A closed polygon without its repeated first vertex; either orientation; at least 3 vertices.
using Ring = std::vector<FieldPoint>;

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
