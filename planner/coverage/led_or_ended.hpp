#pragma once
// Which large outlines rows are led around, and at which they end.

#include "planner/coverage/cover.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace furrow::planner {

/// What a coverage costs, by which it is chosen what rows are led around, in metres flown:
///
///     length_weight (route + corners turn_cost / 2) + area_weight (missed + repeated) / swath
///
/// with the weights of `avoidance`, the route with all ways between strips (straight where they
/// leap), corners those sharper than 45 degrees, two for each turn to the next row, and the areas
/// of the whole field. Ground missed weighs as much as ground repeated: rows that are led around
/// may leave more of it unsprayed.
///
/// @param turn_cost  Of SwathSettings, >= 0.
/// @pre  `coverage.sweep` has a value.
double coverage_cost_m(const Coverage& coverage, Length swath, const AvoidanceSettings& avoidance,
                       Length turn_cost);

/// The coverage of a field whose rows end at these obstacles, by number.
using Covering =
    std::function<Expected<Coverage, PlanError>(const std::vector<std::size_t>& ends_rows)>;

struct LedOrEnded {
  std::vector<std::size_t> ends_rows;
  Expected<Coverage, PlanError> coverage;
};

/// Outlines around which it is tried to lead rows.
inline constexpr std::size_t most_outlines_tried = 4;

/// Ends rows at all outlines that a circle of two swaths does not hold, but for those around which
/// they cost less by `coverage_cost_m`: the first four are tried one after another, that of the
/// least ground first. Half circles lead around all.
///
/// Cost: up to five calls of `covering`.
LedOrEnded led_or_ended(const Field& field, Length swath, const AvoidanceSettings& avoidance,
                        Length turn_cost, const Covering& covering);

}  // namespace furrow::planner
