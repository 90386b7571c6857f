#include "scheduler/orders.hpp"

#include "core/require.hpp"

#include <utility>

namespace furrow::scheduler {
namespace {

/// A piece of a strip that is sprayed from end to end, as the first of its sortie.
Piece end_piece(const planner::Route& route, const planner::Strip& strip, CellRange cells) {
  return {.cells = cells,
          .entry = planner::start_point(route, strip, cells.first),
          .from = route.centers[cells.first],
          .to = route.centers[end(cells) - 1],
          .exit = planner::stop_point(route, strip, end(cells) - 1)};
}

Piece piece(const planner::Route& route, const planner::Strip& strip, CellRange cells,
            std::uint32_t share_first) {
  if (planner::sprays_ends(strip)) return end_piece(route, strip, cells);
  const bool is_strip_start = cells.first == strip.cells.first;
  const bool continues = cells.first > share_first && (!is_strip_start || strip.continues);
  const FieldPoint begin = route.centers[continues ? cells.first - 1 : cells.first];
  return {.cells = cells,
          .entry = is_strip_start ? strip.joins.value_or(begin) : begin,
          .from = route.centers[cells.first],
          .to = route.centers[end(cells) - 1],
          .exit = route.centers[end(cells) - 1]};
}

/// The cells first .. last - 1 of the route, one piece per strip.
SortieOrder sortie_order(const planner::Route& route, const UavPlan& uav, std::uint32_t first,
                         std::uint32_t last, const Station& landing) {
  SortieOrder order{.pieces = {}, .station = landing.id};
  for (std::size_t s = planner::strip_of(route, first); first < last; ++s) {
    const planner::Strip& strip = route.strips[s];
    const std::uint32_t stop = std::min(last, end(strip.cells));
    Piece next = piece(route, strip, {first, stop - first}, uav.cells.first);
    if (!order.pieces.empty()) {
      next.approach = strip.approach;
      next.approach_altitudes_m = strip.approach_altitudes_m;
    }
    next.width = strip.width;
    order.pieces.push_back(std::move(next));
    first = stop;
  }
  return order;
}

}  // namespace

std::vector<SortieOrder> orders(const planner::Route& route, const UavPlan& uav) {
  std::vector<SortieOrder> sorties;
  if (uav.cells.count == 0) return sorties;
  std::uint32_t first = uav.cells.first;
  for (const std::uint32_t index : uav.solution.plan.returns) {
    const std::uint32_t stop = uav.cells.first + index + 1;
    require(stop > first && stop < end(uav.cells), "return points rise and lie within the share");
    sorties.push_back(sortie_order(route, uav, first, stop, landing(uav, sorties.size())));
    first = stop;
  }
  sorties.push_back(sortie_order(route, uav, first, end(uav.cells), landing(uav, sorties.size())));
  return sorties;
}

std::vector<Piece> pieces(const std::vector<SortieOrder>& sorties) {
  std::vector<Piece> all;
  for (const SortieOrder& sortie : sorties) {
    all.insert(all.end(), sortie.pieces.begin(), sortie.pieces.end());
  }
  return all;
}

}  // namespace furrow::scheduler
