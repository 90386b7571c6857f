#pragma once
// The work of a mission, cut to the sizes in which it is planned, released and proven.

#include "core/geometry.hpp"
#include "core/ids.hpp"

#include <cstdint>
#include <vector>

namespace furrow {

/// Half-open run of cells [first, first + count) in the order of the coverage route. A cell is the
/// unit of the ledger: it is sprayed once its centre has been passed with the valve open.
struct CellRange {
  std::uint32_t first;
  std::uint32_t count;
  friend constexpr bool operator==(CellRange, CellRange) = default;
};

constexpr std::uint32_t end(CellRange r) { return r.first + r.count; }

/// A straight run of cells inside one strip.
///
/// The valve is open from `entry` over `from` to `to`, and closed nowhere between. Where a piece
/// continues sprayed ground, `entry` is the centre of the cell before its first; where it starts
/// afresh, `entry == from`. `from` and `to` are the centres of its first and last cell; centres
/// are evenly spaced between them.
struct Piece {
  CellRange cells;
  FieldPoint entry, from, to;
};

/// One trip from the supply station and back: what to spray in between, in order.
struct SortieOrder {
  std::vector<Piece> pieces;  ///< At least one.
  StationId station;          ///< Where the sortie ends.
};

}  // namespace furrow
