#pragma once

#include "core/expected.hpp"
#include "core/field.hpp"
#include "planner/coverage/route.hpp"
#include "planner/coverage/swath/areas.hpp"
#include "planner/coverage/swath/settings.hpp"
#include "planner/plan_error.hpp"

#include <cstddef>
#include <vector>

namespace furrow::planner {

/// A straight sprayed stretch.
struct SwathStrip {
  FieldPoint from, to;
  Length width;  ///< The swath, or less where the last row is narrowed.
  /// The way from the end of the strip before, both ends included, valve closed. Empty for the
  /// first strip of each part of the field: no way inside leads there.
  std::vector<FieldPoint> approach;
};

/// A field covered by rows.
struct SwathCoverage {
  std::vector<SwathStrip> strips;  ///< In the order flown, at least one.
  double direction_deg;            ///< Heading of the rows, 0 <= d < 180; of the largest cell.
  std::size_t parts;               ///< Pieces into which margin and holes split the field.
  SprayedAreas areas;              ///< Against the field less holes and obstacles.
  Area dropped;                    ///< What strips below the least length would have sprayed.
  Length sprayed, route;           ///< The strips; the strips and their approaches.
  Length order_bound;  ///< No order of the same groups of rows, flown to and fro, is shorter.
  bool order_exact;    ///< Whether every part's order was solved exactly.
};

/// Covers any polygon by parallel rows, joined inside it.
///
/// Strips and approaches never leave the field drawn in by the margin, which may split it: each
/// part is covered, one after another.
///
/// @param swath  > 0.
///
/// @error  field_invalid     See `field_land`.
/// @error  nothing_to_spray  The margin leaves nothing, or no strip is long enough; or the field
///                           has more than 200 000 rows.
///
/// Cost: a few hundred sweeps of O(rows x crossings) for the direction, then the order of groups.
Expected<SwathCoverage, PlanError> swath_coverage(const Field& field, Length swath,
                                                  const SwathSettings& settings);

/// Where an aircraft went, and whether its valve was open on the way to each place.
struct FlownPlace {
  FieldPoint at;
  bool spraying;   ///< On the leg that ends here.
  Length width{};  ///< Of the spray on this leg; 0: the swath.
};

/// The boom open along a way.
struct BoomRun {
  std::vector<FieldPoint> path;
  Length width;
};

/// The runs of the boom along the tracks, each of one width. The boom lies across the way flown
/// over half a swath, not across each tremble of an aircraft that hovers.
std::vector<BoomRun> boom_runs(Length swath, const std::vector<std::vector<FlownPlace>>& tracks);

/// The areas that flown tracks of one swath left on `field`; and how far they went outside it.
struct FlownCoverage {
  SprayedAreas areas;
  Length outside;  ///< Length of track over no land, more than a micrometre beyond the edge.
};
Expected<FlownCoverage, PlanError> flown_coverage(
    const Field& field, Length swath, const std::vector<std::vector<FlownPlace>>& tracks);

/// Outlines of the land that the tracks leave out, and of the islands in it that they do not.
/// @error  As `field_land`.
Expected<std::vector<Ring>, PlanError> left_out(const Field& field, Length swath,
                                                const std::vector<std::vector<FlownPlace>>& tracks);

/// How much of `ways` lies over no land, more than `tolerance` beyond an edge. Holes and obstacles
/// are no land.
/// @param tolerance  > 0.
/// @error  As `field_land`.
Expected<Length, PlanError> length_outside(const Field& field,
                                           const std::vector<std::vector<FieldPoint>>& ways,
                                           Length tolerance);

}  // namespace furrow::planner
