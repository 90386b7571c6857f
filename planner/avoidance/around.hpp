#pragma once

#include "planner/avoidance/field_plan.hpp"
#include "planner/coverage/swath/swath.hpp"

#include <optional>

namespace furrow::planner {

/// What flying around obstacles came to, beside what half circles would have.
struct AvoidanceRecord {
  AvoidanceFigures planned;
  std::vector<StraightStrip> straight{};  ///< The rows, before they were led around.
  AvoidanceFigures classic{};             ///< Of `half_circles`; `cover` sets it.
  Length safety{};                        ///< That every planned way keeps from obstacles.
  /// Ways between strips that are Dubins turns inside the field; and those for which none was
  /// found among the obstacles or inside, which aircraft turn on the spot.
  std::size_t turns = 0, unturned = 0;
  std::size_t unjoined = 0;  ///< Strips to which no clear way inside leads from the one before.
  std::size_t ended = 0;     ///< Outlines at which rows end, since that costs less.
};

/// Rows led around the obstacles of a field.
struct RowsAround {
  std::vector<SwathStrip> strips;  ///< As of `coverage_around`, in the order flown; may be none.
  std::vector<std::size_t> rows;   ///< The row that each strip is of.
  SprayedAreas areas;
  Length sprayed, route;
  AvoidanceRecord record;
};

/// The yardstick: what half circles would make of the same rows.
///
/// @param rows      `AvoidanceRecord::straight`.
/// @param settings  Margin, hole buffer and avoidance count, as for `rows_around`.
/// @pre    `settings.avoidance` has a value.
/// @error  As `field_land`.
Expected<AvoidanceFigures, PlanError> half_circles(const Field& field,
                                                   const std::vector<StraightStrip>& rows,
                                                   const SwathSettings& settings);

/// Leads straight rows around the obstacles of `field`, and joins what is left of them.
///
/// @param rows      In the order flown; not empty.
/// @param settings  Margin, hole buffer, row overlap, least strip and avoidance count.
/// @pre    `settings.avoidance` has a value.
/// @error  field_invalid     See `field_land`; or obstacles cut the field.
/// @error  nothing_to_spray  No strip is left.
Expected<RowsAround, PlanError> rows_around(const Field& field, const std::vector<SwathStrip>& rows,
                                            const SwathSettings& settings);

/// `swath_coverage` with rows that run on past obstacles and are led around them. Each leg of a
/// detour is a strip of its own that begins where the one before ends.
///
/// @pre    `settings.avoidance` has a value.
/// @param record  Set where there is a coverage.
/// @error  As `swath_coverage`.
Expected<SwathCoverage, PlanError> coverage_around(const Field& field, Length swath,
                                                   const SwathSettings& settings,
                                                   std::optional<AvoidanceRecord>& record);

}  // namespace furrow::planner
