#pragma once

#include "planner/avoidance/around.hpp"
#include "planner/coverage/route.hpp"
#include "planner/coverage/walk.hpp"

#include <vector>

namespace furrow::planner {

/// A walk of cells that is led around obstacles.
struct WalkAround {
  Route route;
  std::vector<std::size_t> leaps;  ///< Strips to which no way leads yet from the strip before.
  RowsAround rows;
};

/// What counts of the settings of a walk where its rows are led around obstacles.
SwathSettings as_rows(const CoverageSettings& settings);

/// `coverage_route` over the cells of obstacles that are led around too, with the valve open or
/// closed, whichever costs less; those that end rows are left out as cells.
///
/// Rows and the steps between them that meet no obstacle stay as they are, sprayed from centre to
/// centre. Others become strips sprayed from end to end, a detour one for each of its legs. No
/// corner is cut near to an obstacle.
///
/// @pre    `settings.avoidance` has a value.
/// @error  As `coverage_route` and `rows_around`.
Expected<WalkAround, PlanError> walk_around(const Field& field, Length swath,
                                            const CoverageSettings& settings);

}  // namespace furrow::planner
