#include "planner/coverage/grid.hpp"

#include "planner/coverage/land.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace furrow::planner {
namespace {

constexpr double max_cells = 20e6;

// An edge in cell units from the grid's origin, the lower end first.
struct Edge {
  double x0, y0, x1, y1;

  double x_at(double y) const {
    return y1 == y0 ? x0
                    : std::clamp(x0 + (y - y0) / (y1 - y0) * (x1 - x0), std::min(x0, x1),
                                 std::max(x0, x1));
  }
};

std::vector<Edge> edges_of(const std::vector<Ring>& rings, const Grid& grid) {
  std::vector<Edge> edges;
  const double side_m = grid.cell.base();
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const FieldVector a = ring[i] - grid.origin;
      const FieldVector b = ring[(i + 1) % ring.size()] - grid.origin;
      const Edge edge{a.x.base() / side_m, a.y.base() / side_m, b.x.base() / side_m,
                      b.y.base() / side_m};
      edges.push_back(edge.y0 <= edge.y1 ? edge : Edge{edge.x1, edge.y1, edge.x0, edge.y0});
    }
  }
  return edges;
}

std::int32_t clamped(double value, std::int32_t low, std::int32_t high) {
  return static_cast<std::int32_t>(std::clamp(value, double(low), double(high)));
}

// Marks the cells of `row` whose centre an odd number of edges has on its left.
void fill_inside(Grid& grid, std::int32_t row, const std::vector<Edge>& edges,
                 std::vector<double>& crossings) {
  const double y = row + 0.5;
  crossings.clear();
  for (const Edge& e : edges) {
    if (e.y0 <= y && y < e.y1) crossings.push_back(e.x_at(y));
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const auto first = clamped(std::ceil(crossings[i] - 0.5), 0, grid.columns);
    const auto last = clamped(std::ceil(crossings[i + 1] - 0.5), 0, grid.columns);
    for (std::int32_t c = first; c < last; ++c) grid.workable[grid.index(c, row)] = 1;
  }
}

// Clears the cells of `row` whose inside, less a rim of `slack`, an edge runs through.
void clear_crossed(Grid& grid, std::int32_t row, const std::vector<Edge>& edges, double slack) {
  const double low = row + slack, high = row + 1 - slack;
  for (const Edge& e : edges) {
    if (e.y1 <= low || e.y0 >= high) continue;
    const bool level = e.y0 == e.y1;
    const double xa = level ? e.x0 : e.x_at(std::max(low, e.y0));
    const double xb = level ? e.x1 : e.x_at(std::min(high, e.y1));
    const auto first = clamped(std::floor(std::min(xa, xb) + slack), 0, grid.columns);
    const auto last = clamped(std::ceil(std::max(xa, xb) - slack), 0, grid.columns);
    for (std::int32_t c = first; c < last; ++c) grid.workable[grid.index(c, row)] = 0;
  }
}

// Clears the cells that the inside of an outline touches.
void clear_outlined(Grid& grid, const Ring& outline, double slack) {
  Grid covered{grid.origin, grid.cell, grid.columns, grid.rows, {}};
  covered.workable.assign(grid.workable.size(), 0);
  Grid inner = covered;
  std::fill(inner.workable.begin(), inner.workable.end(), 1);
  const std::vector<Edge> edges = edges_of({outline}, grid);
  std::vector<double> crossings;
  for (std::int32_t row = 0; row < grid.rows; ++row) {
    fill_inside(covered, row, edges, crossings);
    clear_crossed(inner, row, edges, slack);
  }
  for (std::size_t i = 0; i < grid.workable.size(); ++i) {
    if (covered.workable[i] == 1 || inner.workable[i] == 0) grid.workable[i] = 0;
  }
}

void clear_around(Grid& grid, const Obstacle& obstacle, double slack) {
  if (!obstacle.outline.empty()) return clear_outlined(grid, obstacle.outline, slack);
  const double side_m = grid.cell.base();
  const double x = (obstacle.center.x - grid.origin.x).base() / side_m;
  const double y = (obstacle.center.y - grid.origin.y).base() / side_m;
  const double radius = obstacle.radius.base() / side_m - slack;
  if (radius <= 0) return;
  for (auto r = clamped(y - radius, 0, grid.rows); r < clamped(y + radius + 1, 0, grid.rows); ++r) {
    const double dy = y - std::clamp(y, double(r), r + 1.0);
    for (auto c = clamped(x - radius, 0, grid.columns);
         c < clamped(x + radius + 1, 0, grid.columns); ++c) {
      const double dx = x - std::clamp(x, double(c), c + 1.0);
      if (std::hypot(dx, dy) < radius) grid.workable[grid.index(c, r)] = 0;
    }
  }
}

// Clears the cells whose centre is nearer than `reach`.
void clear_near(Grid& grid, const Obstacle& obstacle, Length reach) {
  const Length all = obstacle.radius + reach;
  const FieldVector center = obstacle.center - grid.origin;
  const auto place = [&](Length at, std::int32_t most) { return clamped(at / grid.cell, 0, most); };
  for (auto r = place(center.y - all, grid.rows); r < place(center.y + all + grid.cell, grid.rows);
       ++r) {
    for (auto c = place(center.x - all, grid.columns);
         c < place(center.x + all + grid.cell, grid.columns); ++c) {
      if (-depth_in(obstacle, grid.center(c, r)) < reach) grid.workable[grid.index(c, r)] = 0;
    }
  }
}

// How far centres are from what is `safety` away from the ways between them; 0 where cells that an
// obstacle does not touch are enough.
Length centre_reach(Length safety, Length cell) {
  if (safety <= 0.5 * cell) return {};
  return metres(std::hypot(safety.base(), 0.5 * cell.base()));
}

bool is_sound(const Obstacle& o) {
  return std::isfinite(o.center.x.base()) && std::isfinite(o.center.y.base()) &&
         std::isfinite(o.radius.base()) && o.radius >= Length{};
}

struct Extent {
  FieldPoint low, high;
};

Extent extent_of(const Ring& ring) {
  Extent e{ring.front(), ring.front()};
  for (const FieldPoint p : ring) {
    e.low = {std::min(e.low.x, p.x), std::min(e.low.y, p.y)};
    e.high = {std::max(e.high.x, p.x), std::max(e.high.y, p.y)};
  }
  return e;
}

}  // namespace

Expected<Grid, PlanError> field_grid(const Field& field, Length swath, Length margin,
                                     Length safety) {
  require(swath > Length{} && margin >= Length{} && safety >= Length{},
          "a swath is wider than 0, margins are at least 0");
  const auto rings = land_rings(field, margin);
  if (!rings) return Unexpected{rings.error()};
  for (const Obstacle& o : field.obstacles) {
    if (is_sound(o)) continue;
    return Unexpected{PlanError{PlanFault::field_invalid,
                                fmt::format("obstacle {} is no circle of finite size", o.id)}};
  }

  const Extent extent = extent_of(field.boundary);
  const double wide = (extent.high.x - extent.low.x) / swath;
  const double high = (extent.high.y - extent.low.y) / swath;
  if (!(wide * high <= max_cells)) {
    return Unexpected{
        PlanError{PlanFault::field_invalid, fmt::format("{:.0f} cells of {} m are more than {:.0f}",
                                                        wide * high, swath.base(), max_cells)}};
  }
  const double slack = 1e-9 * std::max({wide, high, 1.0});
  Grid grid{.origin = extent.low,
            .cell = swath,
            .columns = static_cast<std::int32_t>(std::floor(wide + slack)),
            .rows = static_cast<std::int32_t>(std::floor(high + slack)),
            .workable = {}};
  grid.workable.assign(grid.index(0, grid.rows), 0);

  const std::vector<Edge> edges = edges_of(*rings, grid);
  std::vector<double> crossings;
  for (std::int32_t row = 0; row < grid.rows; ++row) {
    fill_inside(grid, row, edges, crossings);
    clear_crossed(grid, row, edges, slack);
  }
  const Length reach = centre_reach(safety, swath);
  for (const Obstacle& obstacle : field.obstacles) {
    clear_around(grid, obstacle, slack);
    if (reach > Length{}) clear_near(grid, obstacle, reach);
  }

  if (rings->empty()) {
    return Unexpected{PlanError{PlanFault::margin_too_wide,
                                fmt::format("a margin of {} m leaves nothing", margin.base())}};
  }
  if (std::find(grid.workable.begin(), grid.workable.end(), 1) == grid.workable.end()) {
    return Unexpected{
        PlanError{PlanFault::nothing_to_spray,
                  fmt::format("no {} m cell lies fully inside the field with a margin of {} m",
                              swath.base(), margin.base())}};
  }
  return grid;
}

}  // namespace furrow::planner
