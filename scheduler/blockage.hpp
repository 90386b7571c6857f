#pragma once

#include "core/work.hpp"
#include "planner/coverage/route.hpp"

#include <optional>
#include <span>
#include <vector>

namespace furrow::scheduler {

/// An obstacle met in flight, and how far aircraft keep from its edge.
struct KeptObstacle {
  SeenObstacle obstacle;
  Length clearance;
};

/// Cuts what obstacles block out of a list of sorties: in the piece that holds `first`, the next
/// run of cells that are too near to one. What the piece has before stays, what it has behind
/// follows as a piece of its own, flown to straight. A sortie that has nothing left is dropped.
///
/// Where no cell of the rest of the piece is too near it is the way to `first` that is blocked:
/// then all from there to where the nearest obstacle is further away is cut, by 1, 2, 4 or 8 cells
/// more than its clearance, and where none is so near all the rest.
///
/// @param first  The cell to spray next, where the aircraft is held up.
/// @return  The cells cut out. Nothing, and nothing is changed, where no obstacle is known or no
///          piece holds the cell.
std::optional<CellRange> cut_blocked(const planner::Route& route, std::vector<SortieOrder>& sorties,
                                     std::uint32_t first, std::span<const KeptObstacle> obstacles);

}  // namespace furrow::scheduler
