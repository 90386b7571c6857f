#include "scheduler/blockage.hpp"

#include <algorithm>

namespace furrow::scheduler {
namespace {

bool is_too_near(FieldPoint place, std::span<const KeptObstacle> obstacles, Length more) {
  return std::any_of(obstacles.begin(), obstacles.end(), [&](const KeptObstacle& o) {
    return distance(place, o.obstacle.center) < o.obstacle.radius + o.clearance + more;
  });
}

/// The first run of cells in [first, stop) that are nearer to an obstacle than its clearance and
/// `more`; nothing without one.
std::optional<CellRange> shadow(const planner::Route& route, std::uint32_t first,
                                std::uint32_t stop, std::span<const KeptObstacle> obstacles,
                                Length more) {
  const planner::Strip& strip = route.strips[planner::strip_of(route, first)];
  const auto is_dark = [&](std::uint32_t cell) {
    return is_too_near(planner::start_point(route, strip, cell), obstacles, more) ||
           is_too_near(route.centers[cell], obstacles, more) ||
           is_too_near(planner::stop_point(route, strip, cell), obstacles, more);
  };
  std::uint32_t from = first;
  while (from < stop && !is_dark(from)) ++from;
  std::uint32_t to = from;
  while (to < stop && is_dark(to)) ++to;
  if (from == to) return std::nullopt;
  return CellRange{from, to - from};
}

/// What an aircraft that is held up before `first` is kept from of [first, stop).
CellRange blocked(const planner::Route& route, std::uint32_t first, std::uint32_t stop,
                  std::span<const KeptObstacle> obstacles) {
  constexpr int widest = 8;  // cells
  if (const auto dark = shadow(route, first, stop, obstacles, {})) return *dark;
  const planner::Strip& strip = route.strips[planner::strip_of(route, first)];
  const Length cell = planner::cell_length(route, strip);
  for (int cells = 1; cells <= widest; cells *= 2) {
    const auto near = shadow(route, first, stop, obstacles, 1.0 * cells * cell);
    if (near) return {first, end(*near) - first};
  }
  return {first, stop - first};
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
    const CellRange cut = blocked(route, first, end(whole.cells), obstacles);
    auto next = sortie->pieces.erase(at);
    const std::uint32_t stop = end(cut);
    if (stop < end(whole.cells)) next = sortie->pieces.insert(next, behind(route, whole, stop));
    if (cut.first > whole.cells.first) sortie->pieces.insert(next, before(route, whole, cut.first));
    if (sortie->pieces.empty()) sorties.erase(sortie);
    return cut;
  }
  return std::nullopt;
}

}  // namespace furrow::scheduler
