#include "scheduler/orders.hpp"

#include "core/require.hpp"

#include <algorithm>

namespace furrow::scheduler {
namespace {

/// The strip that holds `cell`.
std::size_t strip_of(const planner::Route& route, std::uint32_t cell) {
  const auto after =
      std::upper_bound(route.strips.begin(), route.strips.end(), cell,
                       [](std::uint32_t c, const planner::Strip& s) { return c < s.cells.first; });
  return static_cast<std::size_t>(after - route.strips.begin()) - 1;
}

Piece piece(const planner::Route& route, const planner::Strip& strip, CellRange cells,
            std::uint32_t share_first) {
  const bool is_strip_start = cells.first == strip.cells.first;
  const bool continues = cells.first > share_first && (!is_strip_start || strip.continues);
  return {.cells = cells,
          .entry = route.centers[continues ? cells.first - 1 : cells.first],
          .from = route.centers[cells.first],
          .to = route.centers[end(cells) - 1]};
}

/// The cells first .. last - 1 of the route, one piece per strip.
SortieOrder sortie_order(const planner::Route& route, const UavPlan& uav, std::uint32_t first,
                         std::uint32_t last) {
  SortieOrder order{.pieces = {}, .station = uav.station.id};
  for (std::size_t s = strip_of(route, first); first < last; ++s) {
    const planner::Strip& strip = route.strips[s];
    const std::uint32_t stop = std::min(last, end(strip.cells));
    order.pieces.push_back(piece(route, strip, {first, stop - first}, uav.cells.first));
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
    sorties.push_back(sortie_order(route, uav, first, stop));
    first = stop;
  }
  sorties.push_back(sortie_order(route, uav, first, end(uav.cells)));
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
