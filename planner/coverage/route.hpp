#pragma once

#include "core/geometry.hpp"
#include "core/work.hpp"

#include <vector>

namespace furrow::planner {

/// A straight run of cells, flown in one go. `from` and `to` are the centres of its end cells.
struct Strip {
  CellRange cells;
  FieldPoint from, to;
  /// Whether the way here from the strip before is a single sprayed move between neighbouring
  /// cells; otherwise it is a ferry with the valve closed. False for the first strip.
  bool continues;
  /// The ferry from the end of the strip before to the beginning of this one, both included, which
  /// lie up to half a cell beyond the centres. Empty where the ferry is straight from centre to
  /// centre.
  std::vector<FieldPoint> approach{};
};

/// The order in which a field is covered: where every coverage model ends and all further planning
/// starts.
struct Route {
  /// Distance between the centres of neighbouring cells; their mean where strips differ.
  Length cell;
  std::vector<FieldPoint> centers;  ///< N cells in the order flown, N >= 1.
  std::vector<Strip> strips;        ///< Contiguous, in order; together all N cells.
  std::vector<FieldPoint> missed;   ///< Centres of workable cells that the route leaves out.
};

}  // namespace furrow::planner
