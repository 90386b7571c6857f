#include "planner/coverage/swath/strips.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

constexpr double nothing = 1e-11;  // share of the extent that counts as no length

struct Crossing {
  double u_m;
  int edge;
};

struct Interval {
  double low_m, high_m;
};

struct Extent {
  double low_m = INFINITY, high_m = -INFINITY, reach_m = 0;
};

Extent extent_across(const LandPart& piece, RowFrame frame) {
  Extent e;
  for (const PointM p : piece.outer) {
    const PointM q = frame.to(p);
    e.low_m = std::min(e.low_m, q.y);
    e.high_m = std::max(e.high_m, q.y);
    e.reach_m = std::max({e.reach_m, std::abs(q.x), std::abs(q.y)});
  }
  return e;
}

std::vector<Row> rows_across(const Extent& extent, const SweepRule& rule) {
  const double half_m = rule.swath_m / 2;
  const double slack_m = nothing * extent.reach_m;
  // A line exactly on the outermost edge would meet nothing.
  const double first_m = extent.low_m + std::max(rule.edge_gap_m, slack_m);
  const double last_m = extent.high_m - std::max(rule.edge_gap_m, slack_m);
  if (last_m - first_m <= slack_m) {
    return {{(extent.low_m + extent.high_m) / 2, half_m}};
  }
  const double steps = (last_m - first_m) / rule.swath_m;
  // A remainder below a micrometre of swath is rounding, not land.
  const auto full = static_cast<std::size_t>(std::floor(steps + 1e-6)) + 1;
  std::vector<Row> rows;
  for (std::size_t k = 0; k < full; ++k) {
    rows.push_back({std::min(first_m + static_cast<double>(k) * rule.swath_m, last_m), half_m});
  }
  const double rest_m = last_m - rows.back().v_m;
  if (rest_m > 1e-6 * rule.swath_m) {
    const double narrow_m = last_m + half_m - rest_m / 2;
    const bool narrows = rule.last_row == LastRow::narrowed && narrow_m < extent.high_m - slack_m;
    rows.push_back(narrows ? Row{narrow_m, rest_m / 2} : Row{last_m, half_m});
  }
  return rows;
}

using Crossings = std::vector<std::vector<Crossing>>;

Crossings crossings_of(const LandPart& piece, RowFrame frame, const std::vector<Row>& rows) {
  Crossings found(rows.size());
  int edge = 0;
  each_edge(piece, [&](PointM from, PointM to) {
    PointM a = frame.to(from), b = frame.to(to);
    if (a.y > b.y) std::swap(a, b);
    const auto below = [](const Row& row, double v_m) { return row.v_m < v_m; };
    auto row = std::lower_bound(rows.begin(), rows.end(), a.y, below);
    for (; row != rows.end() && row->v_m < b.y; ++row) {
      const double t = (row->v_m - a.y) / (b.y - a.y);
      found[static_cast<std::size_t>(row - rows.begin())].push_back(
          {std::clamp(a.x + t * (b.x - a.x), std::min(a.x, b.x), std::max(a.x, b.x)), edge});
    }
    ++edge;
  });
  return found;
}

// For each row, the stretches where an edge of the land runs through the band.
std::vector<std::vector<Interval>> blocked_of(const LandParts& land, RowFrame frame,
                                              const std::vector<Row>& rows, double slack_m) {
  std::vector<std::vector<Interval>> blocked(rows.size());
  double widest_m = 0;
  for (const Row& row : rows) widest_m = std::max(widest_m, row.half_width_m);
  const auto block = [&](PointM from, PointM to) {
    PointM a = frame.to(from), b = frame.to(to);
    if (a.y > b.y) std::swap(a, b);
    const auto below = [](const Row& row, double v_m) { return row.v_m < v_m; };
    auto row = std::lower_bound(rows.begin(), rows.end(), a.y - widest_m, below);
    for (; row != rows.end() && row->v_m - widest_m < b.y; ++row) {
      const double low_m = row->v_m - row->half_width_m + slack_m;
      const double high_m = row->v_m + row->half_width_m - slack_m;
      if (b.y <= low_m || a.y >= high_m) continue;
      const auto u_at = [&](double v_m) {
        if (b.y == a.y) return a.x;
        return a.x + (v_m - a.y) / (b.y - a.y) * (b.x - a.x);
      };
      const double u0 = a.y < low_m ? u_at(low_m) : a.x;
      const double u1 = b.y > high_m ? u_at(high_m) : b.x;
      blocked[static_cast<std::size_t>(row - rows.begin())].push_back(
          {std::min(u0, u1), std::max(u0, u1)});
    }
  };
  for (const LandPart& part : land) each_edge(part, block);
  return blocked;
}

// What is left of `chord` outside all intervals, in order.
void append_free(Chord chord, std::vector<Interval>& blocked, std::vector<Chord>& out) {
  std::sort(blocked.begin(), blocked.end(),
            [](const Interval& a, const Interval& b) { return a.low_m < b.low_m; });
  double free_from_m = chord.low_m;
  for (const Interval& b : blocked) {
    if (b.high_m <= free_from_m || b.low_m >= chord.high_m) continue;
    if (b.low_m > free_from_m) {
      Chord piece = chord;
      piece.low_m = free_from_m;
      piece.high_m = b.low_m;
      out.push_back(piece);
    }
    free_from_m = b.high_m;
  }
  if (free_from_m < chord.high_m) {
    chord.low_m = free_from_m;
    out.push_back(chord);
  }
}

std::vector<Chord> chords_of(const LandPart& piece, const LandParts& land, RowFrame frame,
                             const std::vector<Row>& rows, EdgeMode edges, double slack_m) {
  Crossings crossings = crossings_of(piece, frame, rows);
  std::vector<std::vector<Interval>> blocked;
  if (edges == EdgeMode::stay_inside) blocked = blocked_of(land, frame, rows, slack_m);
  std::vector<Chord> chords;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::vector<Crossing>& line = crossings[r];
    std::sort(line.begin(), line.end(), [](const Crossing& a, const Crossing& b) {
      return a.u_m != b.u_m ? a.u_m < b.u_m : a.edge < b.edge;
    });
    for (std::size_t i = 0; i + 1 < line.size(); i += 2) {
      const Chord chord{r, line[i].u_m, line[i + 1].u_m, line[i].edge, line[i + 1].edge};
      if (edges == EdgeMode::stay_inside) {
        append_free(chord, blocked[r], chords);
      } else {
        chords.push_back(chord);
      }
    }
  }
  std::erase_if(chords, [&](const Chord& chord) { return chord.length_m() <= 10 * slack_m; });
  return chords;
}

}  // namespace

Sweep sweep(const LandPart& piece, const LandParts& land, RowFrame frame, const SweepRule& rule) {
  const Extent extent = extent_across(piece, frame);
  Sweep made{frame, rows_across(extent, rule), {}, 0};
  made.chords = chords_of(piece, land, frame, made.rows, rule.edges, nothing * extent.reach_m);
  std::erase_if(made.chords, [&](const Chord& chord) {
    if (chord.length_m() >= rule.min_strip_m) return false;
    made.dropped_m2 += chord.length_m() * 2 * made.rows[chord.row].half_width_m;
    return true;
  });
  return made;
}

std::vector<Chord> chords_at(const LandPart& piece, const LandParts& land, RowFrame frame, Row row,
                             EdgeMode edges) {
  return chords_of(piece, land, frame, {row}, edges, nothing * extent_across(piece, frame).reach_m);
}

}  // namespace furrow::planner
