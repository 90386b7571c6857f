#include "planner/avoidance/walk_around.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

constexpr Length same = metres(1e-6);

// A row to fly, and what it is in the walk.
struct WalkRow {
  enum class Kind {
    step,  // sprayed, from the end of one strip of cells to the beginning of the next
    pass,  // a strip of two cells or more, from centre to centre
    cell,  // a strip of one cell that nothing leads to, from edge to edge
  };
  Kind kind;
  std::size_t strip;  // of the walk
  SwathStrip line;
};

// Along the strips of the walk.
SwathStrip across_cell(const Route& walk, FieldPoint centre, double direction_deg) {
  const double angle = direction_deg * M_PI / 180;
  const Length half = 0.5 * walk.cell;
  const FieldVector ahead{std::sin(angle) * half, std::cos(angle) * half};
  const FieldVector back{-ahead.x, -ahead.y};
  return {centre + back, centre + ahead, walk.cell, {}};
}

std::vector<WalkRow> rows_of(const Route& walk, double direction_deg) {
  using Kind = WalkRow::Kind;
  std::vector<WalkRow> rows;
  for (std::size_t i = 0; i < walk.strips.size(); ++i) {
    const Strip& s = walk.strips[i];
    const auto at_once = [](FieldPoint p) { return std::vector{p, p}; };
    if (s.continues) {
      const FieldPoint from = walk.strips[i - 1].end;
      rows.push_back({Kind::step, i, {from, s.begin, walk.cell, at_once(from)}});
    }
    if (s.cells.count > 1) {
      auto approach = s.continues ? at_once(s.begin) : std::vector<FieldPoint>{};
      rows.push_back({Kind::pass, i, {s.begin, s.end, walk.cell, std::move(approach)}});
    } else if (!s.continues) {
      rows.push_back({Kind::cell, i, across_cell(walk, s.begin, direction_deg)});
    }
  }
  return rows;
}

// Puts the rows together to a route again.
class Builder {
 public:
  Builder(const Route& walk, const std::vector<WalkRow>& rows, const RowsAround& around,
          std::vector<Obstacle> led, Length clearance)
      : walk_{walk}, rows_{rows}, around_{around}, led_{std::move(led)}, clearance_{clearance} {}

  WalkAround built() {
    made_.route.cell = walk_.cell;
    made_.route.missed = walk_.missed;
    for (std::size_t k = 0; k < around_.strips.size(); ++k) {
      if (becomes_part_of_next(k)) {
        is_continued_ = true;
        continue;
      }
      if (keeps_cells(k)) {
        add_cells(k);
      } else {
        add_line(k);
      }
      is_continued_ = false;
    }
    made_.rows = around_;
    return std::move(made_);
  }

 private:
  const WalkRow& row(std::size_t k) const { return rows_[around_.rows[k]]; }

  bool is_whole(std::size_t k) const {
    const SwathStrip &flown = around_.strips[k], &wanted = row(k).line;
    return flown.from == wanted.from && flown.to == wanted.to;
  }

  // Whether an arc that cuts the corner there may come too near to an obstacle.
  bool is_near(FieldPoint corner) const {
    const Length more = clearance_ + 0.5 * walk_.cell;
    return std::any_of(led_.begin(), led_.end(),
                       [&](const Obstacle& o) { return -depth_in(o, corner) < more; });
  }

  // A pass that stays as the walk has it.
  bool keeps_cells(std::size_t k) const {
    const bool is_pass = row(k).kind == WalkRow::Kind::pass && is_whole(k);
    return is_pass && !is_near(around_.strips[k].from) && !is_near(around_.strips[k].to);
  }

  // A step between two such passes.
  bool becomes_part_of_next(std::size_t k) const {
    if (row(k).kind != WalkRow::Kind::step || !is_whole(k) || !ends_with_cells_) return false;
    const bool is_followed =
        k + 1 < around_.strips.size() && row(k + 1).strip == row(k).strip && keeps_cells(k + 1);
    return is_followed && distance(made_.route.strips.back().end, around_.strips[k].from) < same;
  }

  CellRange next_cells(std::uint32_t count) const {
    return {static_cast<std::uint32_t>(made_.route.centers.size()), count};
  }

  void add_cells(std::size_t k) {
    const Strip& s = walk_.strips[row(k).strip];
    append(k, centre_strip(next_cells(s.cells.count), s.from, s.to, is_continued_));
    const auto first = walk_.centers.begin() + s.cells.first;
    made_.route.centers.insert(made_.route.centers.end(), first, first + s.cells.count);
    ends_with_cells_ = true;
  }

  void add_line(std::size_t k) {
    const SwathStrip& line = around_.strips[k];
    const double cells = std::max(1.0, std::round(distance(line.from, line.to) / walk_.cell));
    const auto count = static_cast<std::uint32_t>(cells);
    append(k, end_strip(next_cells(count), line.from, line.to, {}));
    const Strip& strip = made_.route.strips.back();
    const FieldVector way = strip.to - strip.from;
    for (std::uint32_t i = 0; i + 1 < count; ++i) {
      const double share = static_cast<double>(i) / (count - 1);
      made_.route.centers.push_back(strip.from + FieldVector{share * way.x, share * way.y});
    }
    made_.route.centers.push_back(strip.to);  // the very place that the strip names
    ends_with_cells_ = false;
  }

  void append(std::size_t k, Strip strip) {
    const std::vector<FieldPoint>& approach = around_.strips[k].approach;
    if (approach.size() > 2) strip.approach.assign(approach.begin() + 1, approach.end() - 1);
    if (approach.empty() && k > 0) made_.leaps.push_back(made_.route.strips.size());
    made_.route.strips.push_back(std::move(strip));
  }

  const Route& walk_;
  const std::vector<WalkRow>& rows_;
  const RowsAround& around_;
  std::vector<Obstacle> led_;  // around which rows are led
  Length clearance_;
  WalkAround made_{};
  bool ends_with_cells_ = false;  // the route so far
  bool is_continued_ = false;     // by a step that was left out
};

}  // namespace

SwathSettings as_rows(const CoverageSettings& settings) {
  SwathSettings rows;
  rows.margin = settings.margin;
  rows.avoidance = settings.avoidance;
  return rows;
}

Expected<WalkAround, PlanError> walk_around(const Field& field, Length swath,
                                            const CoverageSettings& settings) {
  require(settings.avoidance.has_value(), "obstacles are flown around by settings");
  const auto& ends_rows = settings.avoidance->ends_rows;
  const auto walk = coverage_route(without_led_around(field, ends_rows), swath, settings);
  if (!walk) return Unexpected{walk.error()};
  const std::vector<WalkRow> rows = rows_of(*walk, settings.work_direction_deg);
  std::vector<SwathStrip> lines;
  lines.reserve(rows.size());
  for (const WalkRow& row : rows) lines.push_back(row.line);
  auto around = rows_around(field, lines, as_rows(settings));
  if (!around) return Unexpected{around.error()};
  const Length clearance = settings.avoidance->safety + metres(tracking_room_m);
  return Builder{*walk, rows, *around, led_around(field, ends_rows), clearance}.built();
}

}  // namespace furrow::planner
