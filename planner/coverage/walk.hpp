#pragma once

#include "core/expected.hpp"
#include "core/field.hpp"
#include "planner/avoidance/settings.hpp"
#include "planner/coverage/route.hpp"
#include "planner/plan_error.hpp"

#include <cstdint>
#include <optional>

namespace furrow::planner {

/// How a field is cut into cells and walked.
struct CoverageSettings {
  Length margin{};                      ///< Inset from boundary and holes, >= 0.
  Length safety{};                      ///< From obstacles, where `avoidance` says none, >= 0.
  double straight_reward = 2.0;         ///< S > 1.
  double turn_reward = 3.0;             ///< U > S.
  std::uint32_t min_region_cells = 10;  ///< Smaller unvisited regions are reported missed, >= 1.
  double work_direction_deg = 0.0;      ///< Heading of the first strip, clockwise from north.
  std::optional<FieldPoint> start{};    ///< Inside the first cell; chosen when left out.
  /// Without a start: the walk begins in the corner nearest to this place, or to the south-western
  /// end of the field.
  std::optional<FieldPoint> near{};
  /// The walk runs on over obstacles, which are flown around (see `walk_around`); without,
  /// their cells are left out.
  std::optional<AvoidanceSettings> avoidance{};
};

/// Covers `field` by the probability walk: from each cell to the neighbour of largest probability,
/// where going straight on and turning back beside the strip just flown are rewarded.
///
/// Strips run along the work direction and advance away from the side of the field on which the
/// walk starts; at a start without room ahead the first strip runs the other way. Where the walk is
/// stuck and unvisited regions of at least `min_region_cells` are left, it goes on at the nearest
/// corner of one (a ferry).
///
/// @param swath  Side of a cell, > 0.
///
/// @error  field_invalid, nothing_to_spray  See `field_grid`.
/// @error  direction_unsupported  The work direction is no multiple of 90 degrees.
/// @error  start_not_workable     The start lies in no workable cell.
///
/// Source: Wang et al. 2017, section 1.2, equations (2)-(4).
Expected<Route, PlanError> coverage_route(const Field& field, Length swath,
                                          const CoverageSettings& settings);

}  // namespace furrow::planner
