#pragma once

#include "core/expected.hpp"
#include "core/field.hpp"
#include "planner/plan_error.hpp"

#include <cstdint>
#include <vector>

namespace furrow::planner {

/// A field cut into square cells, rows along east, columns along north.
struct Grid {
  FieldPoint origin;  ///< South-western corner of cell (0, 0).
  Length cell;        ///< Side of a cell.
  std::int32_t columns, rows;
  std::vector<std::uint8_t> workable;  ///< 1 or 0, cell (column, row) at row * columns + column.

  bool contains(std::int32_t column, std::int32_t row) const {
    return column >= 0 && row >= 0 && column < columns && row < rows;
  }
  std::size_t index(std::int32_t column, std::int32_t row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  FieldPoint center(std::int32_t column, std::int32_t row) const {
    return {origin.x + (column + 0.5) * cell, origin.y + (row + 0.5) * cell};
  }
};

/// Cuts `field` into cells as wide as the swath. A cell is workable if it lies fully inside the
/// boundary and outside holes and obstacles; touching their edges is allowed.
///
/// The grid starts at the south-western corner of the boundary's bounding box. Lengths of less
/// than 1e-9 of the field's extent count as nothing.
///
/// @param swath   > 0.
/// @param margin  Inset from boundary and holes, >= 0.
/// @param safety  That ways between the centres of neighbouring cells keep from obstacles, >= 0.
///
/// @error   field_invalid     See `land_rings`; or an obstacle is no circle; or there are more than
///                            20 million cells.
/// @error   nothing_to_spray  No cell is workable.
///
/// Time O(cells + rows x edges).
/// Source: Wang et al. 2017, section 1.2 (weights w_e = 1 and w_0 = 0).
Expected<Grid, PlanError> field_grid(const Field& field, Length swath, Length margin,
                                     Length safety = {});

}  // namespace furrow::planner
