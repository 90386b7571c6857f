#include "planner/coverage/route.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

FieldPoint between(FieldPoint from, FieldPoint to, double share) {
  const FieldVector way = to - from;
  return from + FieldVector{share * way.x, share * way.y};
}

// The place after `cells` whole cells of a strip that is sprayed from end to end.
FieldPoint edge_after(const Strip& strip, std::uint32_t cells) {
  if (cells == 0) return strip.begin;
  if (cells == strip.cells.count) return strip.end;
  return between(strip.begin, strip.end, static_cast<double>(cells) / strip.cells.count);
}

// The furthest that a way leads away from the line of a piece.
double aside_m(const Piece& piece, std::span<const FieldPoint> way) {
  const FieldVector along = piece.exit - piece.entry;
  const double length_m = distance(piece.entry, piece.exit).base();
  double most_m = 0.0;
  if (length_m <= 0.0) return most_m;
  for (const FieldPoint at : way) {
    const FieldVector off = at - piece.exit;
    const double cross_m2 = along.x.base() * off.y.base() - along.y.base() * off.x.base();
    most_m = std::max(most_m, std::abs(cross_m2) / length_m);
  }
  return most_m;
}

}  // namespace

Strip end_strip(CellRange cells, FieldPoint begin, FieldPoint end,
                std::vector<FieldPoint> approach) {
  require(cells.count > 0, "a strip has a cell");
  const double half = 0.5 / cells.count;
  return {.cells = cells,
          .from = between(begin, end, half),
          .to = between(begin, end, 1.0 - half),
          .begin = begin,
          .end = end,
          .continues = false,
          .approach = std::move(approach),
          .approach_altitudes_m = {},
          .width = {},
          .joins = {}};
}

Route end_to_end_route(Length cell, std::vector<Strip> strips) {
  require(!strips.empty() && cell > Length{}, "a route has a strip, a cell a length");
  Route route{.cell = cell, .centers = {}, .strips = {}, .missed = {}, .ferries = {}};
  std::uint32_t first = 0;
  for (Strip& s : strips) {
    const double cells = std::max(1.0, std::round(distance(s.begin, s.end) / cell));
    const auto count = static_cast<std::uint32_t>(cells);
    route.strips.push_back(end_strip({first, count}, s.begin, s.end, std::move(s.approach)));
    route.strips.back().width = s.width;
    for (std::uint32_t i = 0; i < count; ++i) {
      route.centers.push_back(between(s.begin, s.end, (i + 0.5) / count));
    }
    // The very places that the strip names.
    route.centers[first] = route.strips.back().from;
    route.centers.back() = route.strips.back().to;
    first += count;
  }
  return route;
}

std::size_t strip_of(const Route& route, std::uint32_t cell) {
  const auto after =
      std::upper_bound(route.strips.begin(), route.strips.end(), cell,
                       [](std::uint32_t c, const Strip& s) { return c < s.cells.first; });
  require(after != route.strips.begin(), "strips begin with the first cell");
  return static_cast<std::size_t>(after - route.strips.begin()) - 1;
}

FieldPoint stop_point(const Route& route, const Strip& strip, std::uint32_t cell) {
  if (!sprays_ends(strip)) return route.centers[cell];
  return edge_after(strip, cell - strip.cells.first + 1);
}

FieldPoint start_point(const Route& route, const Strip& strip, std::uint32_t cell) {
  if (!sprays_ends(strip)) return route.centers[cell];
  return edge_after(strip, cell - strip.cells.first);
}

FieldPoint resume_point(const Route& route, std::uint32_t cell) {
  const std::size_t s = strip_of(route, cell);
  const Strip& strip = route.strips[s];
  const bool is_last = cell + 1 == end(strip.cells) && s + 1 < route.strips.size();
  if (is_last && !route.strips[s + 1].continues) return route.strips[s + 1].begin;
  return stop_point(route, strip, cell);
}

Length cell_length(const Route& route, const Strip& strip) {
  if (!sprays_ends(strip)) return route.cell;
  return (1.0 / strip.cells.count) * distance(strip.begin, strip.end);
}

std::vector<double> cell_lengths_m(const Route& route) {
  std::vector<double> lengths_m(route.centers.size(), route.cell.base());
  for (const Strip& strip : route.strips) {
    const double cell_m = cell_length(route, strip).base();
    for (std::uint32_t c = strip.cells.first; c < end(strip.cells); ++c) lengths_m[c] = cell_m;
  }
  return lengths_m;
}

bool is_high(std::span<const FieldPoint> way) { return way_length(way) > longest_low_way; }

bool are_apart(const Piece& before, const Piece& after, Length swath) {
  if (after.entry == after.exit) return false;
  std::vector<FieldPoint> way{before.exit};
  way.insert(way.end(), after.approach.begin(), after.approach.end());
  way.push_back(after.entry);
  constexpr Length beyond_neighbours = metres(10);
  return way_length(way) > beyond_neighbours || aside_m(before, way) > 1.5 * swath.base();
}

Length approach_length(const Strip& before, const Strip& strip) {
  FieldPoint at = before.end;
  Length sum{};
  for (const FieldPoint next : strip.approach) {
    sum += distance(at, next);
    at = next;
  }
  return sum + distance(at, strip.begin);
}

std::vector<FieldPoint> approach_over(const FerryMap& ferries, const Strip& before,
                                      const Strip& strip) {
  const std::vector<FieldPoint> way = ferries.way(before.end, strip.begin);
  return {way.begin() + 1, way.end() - 1};
}

std::vector<CellStop> cell_stops(const Route& route, CellRange cells) {
  require(cells.count > 0 && end(cells) <= route.centers.size(),
          "a share is not empty and lies within the route");
  std::vector<CellStop> stops;
  stops.reserve(cells.count);
  // Cells are counted, so that sums do not drift.
  double moves = 0.0, ends_m = 0.0;
  MetDetour around;
  for (std::size_t s = strip_of(route, cells.first); stops.size() < cells.count; ++s) {
    const Strip& strip = route.strips[s];
    const double cell_m = cell_length(route, strip).base();
    const std::uint32_t from = std::max(cells.first, strip.cells.first);
    const std::uint32_t to = std::min(end(cells), end(strip.cells));
    for (std::uint32_t cell = from; cell < to; ++cell) {
      const bool is_reached = cell == strip.cells.first && cell > cells.first;
      const bool is_ferried = is_reached && !strip.continues;
      const double approach_m =
          is_ferried ? approach_length(route.strips[s - 1], strip).base() : 0.0;
      if (is_ferried) {
        stops.back().resume = strip.begin;
        stops.back().skipped_m = approach_m;
      }
      double spray_m;
      if (sprays_ends(strip)) {
        spray_m = ends_m + moves * route.cell.base() + (cell - from + 1) * cell_m;
      } else {
        if (cell > cells.first && !is_ferried) moves += 1.0;
        spray_m = ends_m + moves * route.cell.base();
      }
      if (!route.detours.empty()) around = around + route.detours[cell];
      const FieldPoint stop = stop_point(route, strip, cell);
      stops.push_back({stop, stop, spray_m + around.sprayed_m, approach_m, 0.0,
                       around.longer_m - around.sprayed_m});
    }
    if (sprays_ends(strip)) ends_m += (to - from) * cell_m;
  }
  return stops;
}

}  // namespace furrow::planner
