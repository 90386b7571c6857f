#include "scheduler/blockage.hpp"

#include <algorithm>

namespace furrow::scheduler {
namespace {

bool is_too_near(FieldPoint place, std::span<const KeptObstacle> obstacles) {
  return std::any_of(obstacles.begin(), obstacles.end(), [&](const KeptObstacle& o) {
    return distance(place, o.obstacle.center) < o.obstacle.radius + o.clearance;
  });
}

/// Whether a cell of a piece, or the way from its near edge to its centre, is too near.
bool is_shadowed(const planner::Route& route, std::uint32_t cell,
                 std::span<const KeptObstacle> obstacles) {
  const planner::Strip& strip = route.strips[planner::strip_of(route, cell)];
  return is_too_near(planner::start_point(route, strip, cell), obstacles) ||
         is_too_near(route.centers[cell], obstacles);
}

/// One past the last cell of the first run of shadowed cells in [first, stop); `stop` without one.
std::uint32_t end_of_shadow(const planner::Route& route, std::uint32_t first, std::uint32_t stop,
                            std::span<const KeptObstacle> obstacles) {
  const auto is_dark = [&](std::uint32_t cell) { return is_shadowed(route, cell, obstacles); };
  std::uint32_t cell = first;
  while (cell < stop && !is_dark(cell)) ++cell;
  while (cell < stop && is_dark(cell)) ++cell;
  return cell;
}

Piece before(const planner::Route& route, Piece piece, std::uint32_t stop) {
  const planner::Strip& strip = route.strips[planner::strip_of(route, stop - 1)];
  piece.cells.count = stop - piece.cells.first;
  piece.to = route.centers[stop - 1];
  piece.exit = planner::stop_point(route, strip, stop - 1);
  return piece;
}

Piece behind(const planner::Route& route, Piece piece, std::uint32_t first) {
  const planner::Strip& strip = route.strips[planner::strip_of(route, first)];
  piece.cells = {first, end(piece.cells) - first};
  piece.entry = planner::start_point(route, strip, first);
  piece.from = route.centers[first];
  piece.approach.clear();
  return piece;
}

}  // namespace

std::optional<CellRange> cut_blocked(const planner::Route& route, std::vector<SortieOrder>& sorties,
                                     std::uint32_t first, std::span<const KeptObstacle> obstacles) {
  if (obstacles.empty()) return std::nullopt;
  const auto holds = [&](const Piece& p) { return p.cells.first <= first && first < end(p.cells); };
  for (auto sortie = sorties.begin(); sortie != sorties.end(); ++sortie) {
    const auto at = std::find_if(sortie->pieces.begin(), sortie->pieces.end(), holds);
    if (at == sortie->pieces.end()) continue;
    const Piece whole = *at;
    const std::uint32_t stop = end_of_shadow(route, first, end(whole.cells), obstacles);
    auto next = sortie->pieces.erase(at);
    if (stop < end(whole.cells)) next = sortie->pieces.insert(next, behind(route, whole, stop));
    if (first > whole.cells.first) sortie->pieces.insert(next, before(route, whole, first));
    if (sortie->pieces.empty()) sorties.erase(sortie);
    return CellRange{first, stop - first};
  }
  return std::nullopt;
}

}  // namespace furrow::scheduler
