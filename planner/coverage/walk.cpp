#include "planner/coverage/walk.hpp"

#include "planner/coverage/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace furrow::planner {
namespace {

// A cell of the grid, or a step between neighbours.
struct Cell {
  std::int32_t x, y;
  friend bool operator==(Cell, Cell) = default;
  friend Cell operator+(Cell a, Cell b) { return {a.x + b.x, a.y + b.y}; }
  friend Cell operator-(Cell a, Cell b) { return {a.x - b.x, a.y - b.y}; }
  friend Cell operator-(Cell a) { return {-a.x, -a.y}; }
};

constexpr Cell rightwards(Cell step) { return {step.y, -step.x}; }

struct Rewards {
  double straight, turn;
};

// The walk under way: what is still free, where it is, and how it came there.
class Walk {
 public:
  Walk(const Grid& grid, Cell ahead, Rewards rewards, std::uint32_t min_region_cells)
      : grid_{grid},
        free_{grid.workable},
        seen_(free_.size(), 0),
        ahead_{ahead},
        rewards_{rewards},
        min_region_cells_{min_region_cells} {
    left_ = static_cast<std::size_t>(std::count(free_.begin(), free_.end(), 1));
  }

  /// A free cell with no free neighbour on one side of each axis: strips may begin there.
  bool is_corner(Cell c) const {
    const Cell across = rightwards(ahead_);
    return is_free(c) && !(is_free(c + ahead_) && is_free(c - ahead_)) &&
           !(is_free(c + across) && is_free(c - across));
  }

  /// The nearest corner to a place in cell units from the grid's origin, by rings around it.
  std::optional<Cell> nearest_corner(double x, double y) const {
    std::optional<Cell> best;
    double best_d2 = std::numeric_limits<double>::infinity();
    const Cell hub{std::clamp(static_cast<std::int32_t>(std::floor(x)), 0, grid_.columns - 1),
                   std::clamp(static_cast<std::int32_t>(std::floor(y)), 0, grid_.rows - 1)};
    const auto consider = [&](Cell c) {
      if (!grid_.contains(c.x, c.y) || !is_corner(c)) return;
      const double d2 = std::pow(c.x + 0.5 - x, 2) + std::pow(c.y + 0.5 - y, 2);
      if (d2 < best_d2) {
        best_d2 = d2;
        best = c;
      }
    };
    const double hub_d = std::hypot(hub.x + 0.5 - x, hub.y + 0.5 - y);
    for (std::int32_t r = 0; r < std::max(grid_.columns, grid_.rows); ++r) {
      if (r - hub_d > 0 && (r - hub_d) * (r - hub_d) > best_d2) break;
      const std::int32_t west = std::max(hub.x - r, 0),
                         east = std::min(hub.x + r, grid_.columns - 1);
      for (std::int32_t cx = west; cx <= east; ++cx) {
        consider({cx, hub.y - r});
        if (r > 0) consider({cx, hub.y + r});
      }
      const std::int32_t south = std::max(hub.y - r + 1, 0);
      const std::int32_t north = std::min(hub.y + r - 1, grid_.rows - 1);
      for (std::int32_t cy = south; cy <= north; ++cy) {
        consider({hub.x - r, cy});
        consider({hub.x + r, cy});
      }
    }
    return best;
  }

  /// Goes on at `start` after a ferry, or begins there, until it is stuck.
  void run_from(Cell start, Cell advance) {
    jumps_.push_back(visited_.size());
    visit(start);
    heading_ = is_free(start + ahead_) || !is_free(start - ahead_) ? ahead_ : -ahead_;
    turn_back_ = {0, 0};
    while (const auto step = next_step(advance)) {
      if (*step != heading_) {
        // A step aside at a strip's end: the strip beside it runs the other way.
        const bool along = step->x * ahead_.x + step->y * ahead_.y != 0;
        turn_back_ = along ? Cell{0, 0} : -heading_;
      }
      heading_ = *step;
      visit(visited_.back() + *step);
    }
  }

  /// Where to go on once stuck; regions too small for it are given up on the way.
  std::optional<Cell> next_entry() {
    while (left_ > 0) {
      const Cell here = visited_.back();
      const auto entry = nearest_corner(here.x + 0.5, here.y + 0.5);
      require(entry.has_value(), "a finite region has a corner");
      if (keeps_region_of(*entry)) return entry;
    }
    return std::nullopt;
  }

  const std::vector<Cell>& visited() const { return visited_; }
  const std::vector<std::size_t>& jumps() const { return jumps_; }
  const std::vector<Cell>& missed() const { return missed_; }

 private:
  bool is_free(Cell c) const { return grid_.contains(c.x, c.y) && free_[grid_.index(c.x, c.y)]; }

  void take(Cell c) {
    free_[grid_.index(c.x, c.y)] = 0;
    --left_;
  }

  void visit(Cell c) {
    take(c);
    visited_.push_back(c);
  }

  // The neighbour of largest weight. All weights have the same sum below the fraction line of
  // equation (2), so the largest weight is the largest probability; of equals, the first below.
  std::optional<Cell> next_step(Cell advance) const {
    constexpr double w_e = 1.0;
    const Cell here = visited_.back();
    std::optional<Cell> best;
    double best_weight = 0.0;
    const std::array<Cell, 2> sides{rightwards(heading_), -rightwards(heading_)};
    const auto weigh = [&](Cell step) {
      if (!is_free(here + step)) return;
      double weight = w_e;
      if (step == heading_) weight = w_e + rewards_.straight;
      if (step == turn_back_) weight = w_e + rewards_.turn;
      if (weight > best_weight) {
        best_weight = weight;
        best = step;
      }
    };
    weigh(heading_);
    if (sides[0] == advance || sides[1] == advance) {
      weigh(advance);
      weigh(-advance);
    } else {
      weigh(sides[0]);
      weigh(sides[1]);
    }
    return best;
  }

  // Whether the region around `seed` is large enough to fly to; gives it up otherwise.
  bool keeps_region_of(Cell seed) {
    region_.assign(1, seed);
    seen_[grid_.index(seed.x, seed.y)] = 1;
    for (std::size_t i = 0; i < region_.size() && region_.size() < min_region_cells_; ++i) {
      for (const Cell step : {Cell{0, 1}, Cell{1, 0}, Cell{0, -1}, Cell{-1, 0}}) {
        const Cell c = region_[i] + step;
        if (!is_free(c) || seen_[grid_.index(c.x, c.y)]) continue;
        seen_[grid_.index(c.x, c.y)] = 1;
        region_.push_back(c);
      }
    }
    for (const Cell c : region_) seen_[grid_.index(c.x, c.y)] = 0;
    if (region_.size() >= min_region_cells_) return true;
    for (const Cell c : region_) take(c);
    missed_.insert(missed_.end(), region_.begin(), region_.end());
    return false;
  }

  const Grid& grid_;
  std::vector<std::uint8_t> free_;  // workable, not visited, not given up
  std::vector<std::uint8_t> seen_;
  std::size_t left_ = 0;  // how many are free
  Cell ahead_, heading_{}, turn_back_{};
  Rewards rewards_;
  std::uint32_t min_region_cells_;
  std::vector<Cell> visited_, missed_, region_;
  std::vector<std::size_t> jumps_;  // indices of cells reached other than by a step
};

std::optional<Cell> direction(double heading_deg) {
  const double quarters = heading_deg / 90.0;
  if (!std::isfinite(quarters) || std::abs(quarters - std::round(quarters)) > 1e-9) {
    return std::nullopt;
  }
  constexpr std::array<Cell, 4> steps{Cell{0, 1}, Cell{1, 0}, Cell{0, -1}, Cell{-1, 0}};
  const double turn = std::fmod(std::round(quarters), 4.0);
  return steps[static_cast<std::size_t>(turn < 0 ? turn + 4 : turn)];
}

// Cuts the visited cells into straight strips; every jump begins one.
std::vector<Strip> strips_of(const Grid& grid, const Walk& walk) {
  const std::vector<Cell>& cells = walk.visited();
  std::vector<Strip> strips;
  std::size_t next_jump = 0;
  for (std::size_t first = 0; first < cells.size();) {
    const bool jumped = next_jump < walk.jumps().size() && walk.jumps()[next_jump] == first;
    if (jumped) ++next_jump;
    const std::size_t limit =
        next_jump < walk.jumps().size() ? walk.jumps()[next_jump] : cells.size();
    std::size_t end = first + 1;
    while (end < limit &&
           (end == first + 1 || cells[end] - cells[end - 1] == cells[end - 1] - cells[end - 2])) {
      ++end;
    }
    strips.push_back(
        centre_strip({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end - first)},
                     grid.center(cells[first].x, cells[first].y),
                     grid.center(cells[end - 1].x, cells[end - 1].y), !jumped));
    first = end;
  }
  return strips;
}

Route route_of(const Grid& grid, const Walk& walk) {
  Route route{.cell = grid.cell, .centers = {}, .strips = strips_of(grid, walk), .missed = {}};
  for (const Cell c : walk.visited()) route.centers.push_back(grid.center(c.x, c.y));
  for (const Cell c : walk.missed()) route.missed.push_back(grid.center(c.x, c.y));
  return route;
}

// The side away from the half of the field in which the walk starts.
Cell advance_from(const Grid& grid, Cell start, Cell ahead) {
  const Cell east_or_north{std::abs(ahead.y), std::abs(ahead.x)};
  const std::int32_t at = east_or_north.x ? start.x : start.y;
  const std::int32_t size = east_or_north.x ? grid.columns : grid.rows;
  return 2 * at < size ? east_or_north : -east_or_north;
}

}  // namespace

Expected<Route, PlanError> coverage_route(const Field& field, Length swath,
                                          const CoverageSettings& settings) {
  require(settings.straight_reward > 1.0 && settings.turn_reward > settings.straight_reward,
          "the rewards of the walk are 1 < S < U");
  const auto ahead = direction(settings.work_direction_deg);
  if (!ahead) {
    return Unexpected{
        PlanError{PlanFault::direction_unsupported,
                  fmt::format("{} degrees is no multiple of 90", settings.work_direction_deg)}};
  }
  const Length safety = settings.avoidance ? settings.avoidance->safety : settings.safety;
  const auto grid = field_grid(field, swath, settings.margin, planned_clearance(safety));
  if (!grid) return Unexpected{grid.error()};

  Walk walk{*grid,
            *ahead,
            {settings.straight_reward, settings.turn_reward},
            std::max(settings.min_region_cells, 1u)};
  const FieldPoint place = settings.start.value_or(settings.near.value_or(grid->origin));
  const double x = (place.x - grid->origin.x) / grid->cell;
  const double y = (place.y - grid->origin.y) / grid->cell;
  std::optional<Cell> start;
  if (!settings.start) {
    start = walk.nearest_corner(x, y);
  } else if (x >= 0 && y >= 0 && x < grid->columns && y < grid->rows) {
    const Cell cell{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    if (grid->workable[grid->index(cell.x, cell.y)]) start = cell;
  }
  if (!start) {
    return Unexpected{PlanError{
        PlanFault::start_not_workable,
        fmt::format("({}, {}) m lies in no workable cell", place.x.base(), place.y.base()), place}};
  }

  const Cell advance = advance_from(*grid, *start, *ahead);
  walk.run_from(*start, advance);
  while (const auto entry = walk.next_entry()) walk.run_from(*entry, advance);
  return route_of(*grid, walk);
}

}  // namespace furrow::planner
