#pragma once

#include "core/field.hpp"
#include "planner/avoidance/settings.hpp"

#include <optional>

namespace furrow::planner {

/// What a row may do at the edge of the land.
enum class EdgeMode {
  cover_all,    ///< Rows run to the edge and ragged edges get a row of their own; overspray is
                ///< stated.
  stay_inside,  ///< Nothing outside the land is sprayed; what is missed is stated.
};

/// What happens to the last row, where the land is no multiple of the swath.
enum class LastRow {
  shifted,   ///< Full width against the edge, overlapping the row before.
  narrowed,  ///< Only the remaining width is sprayed.
};

enum class HeadlandTurn { clockwise, counter_clockwise };

/// How `swath_coverage` covers a field.
struct SwathSettings {
  Length margin{};       ///< Least distance of flight from every edge, >= 0.
  Length hole_buffer{};  ///< Further distance from holes and obstacles, >= 0.
  Length safety{};       ///< From obstacles, where `avoidance` says none, >= 0.
  EdgeMode edges = EdgeMode::cover_all;
  Length spray_margin{};  ///< In `stay_inside`: least distance of sprayed bands from every edge,
                          ///< for what the position may err, >= 0.
  LastRow last_row = LastRow::shifted;
  /// By how much neighbouring rows overlap, so that errors flown leave hardly any gaps, >= 0 and at
  /// most half the swath; none when left out. Half of it is overspray along edges of `cover_all`,
  /// and left out at the ends of rows in `stay_inside`.
  std::optional<Length> row_overlap{};
  /// Heading of the rows, clockwise from north, as along an AB line; searched when left out.
  std::optional<double> direction_deg{};
  bool cells_may_differ = true;  ///< Without a direction: whether cells choose their own.
  Length min_strip{};            ///< Shorter strips are dropped, >= 0.
  int headland_passes = 0;       ///< Rounds along the edges before the rows, >= 0.
  HeadlandTurn headland_turn = HeadlandTurn::counter_clockwise;
  Length turn_cost = metres(5);      ///< What a turn counts in the search, as metres flown, >= 0.
  std::optional<FieldPoint> near{};  ///< Start or supply: the route begins on the side near it.
  /// Rows run on past obstacles and are led around them, but for those of `ends_rows`; without,
  /// obstacles end rows as holes do.
  std::optional<AvoidanceSettings> avoidance{};
  double miss_tolerance = 5e-4;  ///< Share of the land that rows of `cover_all` may leave out.
};

}  // namespace furrow::planner
