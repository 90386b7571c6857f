#pragma once

#include "planner/avoidance/field_plan.hpp"
#include "planner/coverage/swath/swath.hpp"

#include <optional>

namespace furrow::planner {

/// What flying around obstacles came to, beside what half circles would have.
struct AvoidanceRecord {
  AvoidanceFigures planned, classic;
  Length safety{};  ///< That every planned way keeps from obstacles.
  /// Ways between strips that are Dubins turns inside the field; and those for which none was
  /// found among the obstacles or inside, which aircraft turn on the spot.
  std::size_t turns = 0, unturned = 0;
  std::size_t unjoined = 0;  ///< Strips to which no clear way inside leads from the one before.
};

/// `swath_coverage` with rows that run on past round obstacles and fly around them. Each leg of a
/// detour is a strip of its own that begins where the one before ends. Outlined obstacles end rows.
///
/// @pre    `settings.avoidance` has a value.
/// @param record  Set where there is a coverage.
/// @error  As `swath_coverage`.
Expected<SwathCoverage, PlanError> coverage_around(const Field& field, Length swath,
                                                   const SwathSettings& settings,
                                                   std::optional<AvoidanceRecord>& record);

}  // namespace furrow::planner
