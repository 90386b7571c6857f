#pragma once

#include "planner/coverage/plane.hpp"
#include "planner/coverage/swath/settings.hpp"

#include <cstddef>
#include <vector>

namespace furrow::planner {

/// The numbers of one sweep, unwrapped.
struct SweepRule {
  double swath_m;
  double edge_gap_m;  ///< From the lowest place of the piece to the first row, and on top alike.
  EdgeMode edges = EdgeMode::cover_all;
  LastRow last_row = LastRow::shifted;
  double min_strip_m = 0;
};

/// A stretch of one row inside the piece, in the row frame: from (low_m, v) to (high_m, v).
struct Chord {
  std::size_t row;
  double low_m, high_m;
  int left_edge, right_edge;  ///< Numbers of the edges it ends at, in the order of `each_edge`.

  double length_m() const { return high_m - low_m; }
};

struct Row {
  double v_m;           ///< Place across the rows.
  double half_width_m;  ///< Of the sprayed band.
};

/// The rows of one piece in one direction.
struct Sweep {
  RowFrame frame;
  std::vector<Row> rows;      ///< From low to high v.
  std::vector<Chord> chords;  ///< By row, then from low to high.
  double dropped_m2 = 0;      ///< Of chords shorter than the least strip.
};

/// Cuts `piece` into rows along `frame`, the first `edge_gap_m` from its lowest place, one swath
/// apart. A line that meets a vertex or runs along an edge crosses it by the half-open rule, so
/// crossings always pair.
///
/// In `stay_inside`, chords are shortened so that the whole band of a row stays in `land`.
///
/// Time O(edges + crossings x log crossings per row).
Sweep sweep(const LandPart& piece, const LandParts& land, RowFrame frame, const SweepRule& rule);

/// The chords of `piece` on the single line v = `row.v_m`, by the same rules.
std::vector<Chord> chords_at(const LandPart& piece, const LandParts& land, RowFrame frame, Row row,
                             EdgeMode edges);

}  // namespace furrow::planner
