#pragma once
// The one door to coverage: every model ends in a Route.

#include "planner/avoidance/around.hpp"
#include "planner/coverage/swath/swath.hpp"
#include "planner/coverage/walk.hpp"

#include <optional>
#include <variant>

namespace furrow::planner {

/// How a field is covered: walked on a grid of cells (spec of Wang et al. 2017), or swept by
/// parallel rows of any direction.
using CoverageModel = std::variant<CoverageSettings, SwathSettings>;

/// What the sweep tells of itself.
struct SweepFigures {
  SprayedAreas areas;     ///< From the union of footprints of the strips as planned.
  Area dropped;           ///< What strips below the least length would have sprayed.
  Length sprayed, route;  ///< The strips; the strips and their connections.
  Length order_bound;     ///< No order of the same groups of rows is shorter; of a grid: `sprayed`.
  bool order_exact;
  std::uint32_t parts;  ///< Pieces into which margin and holes split the field.
  std::optional<AvoidanceRecord> avoidance{};  ///< Where obstacles are flown around.
};

/// How `model` flies around obstacles, if it does.
const std::optional<AvoidanceSettings>& avoidance_of(const CoverageModel& model);

/// What `model` keeps from obstacles.
Length safety_of(const CoverageModel& model);

struct Coverage {
  Route route;
  double direction_deg;  ///< Heading of the strips, clockwise from north.
  /// Strips that no way inside the land leads to from the strip before: of the grid model all that
  /// do not continue it, but for those behind an obstacle, of the swath model the first of each
  /// further part of the field.
  std::vector<std::size_t> leaps;
  std::optional<SweepFigures> sweep;  ///< Of the swath model, and of a grid with `avoidance`.
};

/// Covers `field` by `model`.
///
/// Rows are led around round obstacles and outlines that a circle of two swaths holds. Larger
/// outlines end rows, but for those around which rows cost less, see `led_or_ended`. Half circles
/// go around all of them, or end rows where they do not fit.
///
/// @param swath  > 0.
/// @error  As `coverage_route` and `swath_coverage`.
///
/// Cost: with `avoidance` and large outlines, up to five plans of the whole field; half circles,
/// the yardstick, are laid for the chosen one alone.
Expected<Coverage, PlanError> cover(const Field& field, Length swath, const CoverageModel& model);

}  // namespace furrow::planner
