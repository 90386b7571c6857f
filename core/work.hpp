#pragma once
// The work of a mission, cut to the sizes in which it is planned, released and proven.

#include "core/geometry.hpp"
#include "core/ids.hpp"

#include <cstdint>
#include <vector>

namespace furrow {

/// Half-open run of cells [first, first + count) in the order of the coverage route. A cell is the
/// unit of the ledger: it is sprayed once its centre has been passed with the valve open. On a
/// survey it is a place to visit: done once it has been passed.
struct CellRange {
  std::uint32_t first;
  std::uint32_t count;
  friend constexpr bool operator==(CellRange, CellRange) = default;
};

constexpr std::uint32_t end(CellRange r) { return r.first + r.count; }

/// A straight run of cells inside one strip.
///
/// The valve is open from `entry` over `from` and `to` to `exit`, and closed nowhere between.
/// `from` and `to` are the centres of its first and last cell; centres are evenly spaced between
/// them.
///
/// Sprayed from centre to centre, a piece ends at `exit == to`, and begins at `entry == from` or,
/// where it continues sprayed ground, at the centre of the cell before its first. Sprayed from end
/// to end, all four lie on one line, `entry` and `exit` at the outer edges of the end cells.
///
/// Where all four are one place it is visited only: the valve stays closed.
struct Piece {
  CellRange cells;
  FieldPoint entry, from, to, exit;
  /// Way points from the exit of the piece before in the same sortie to `entry`, flown with the
  /// valve closed; none: straight.
  std::vector<FieldPoint> approach{};
  /// Above the datum, one for each way point of the approach, flown straight between them; none:
  /// the height of work is kept [m].
  std::vector<double> approach_altitudes_m{};
  Length width{};  ///< Of the spray, where only a part of the boom is open; 0: all of it.
  friend bool operator==(const Piece&, const Piece&) = default;
};

/// A round obstacle met in flight. No plan made before knew it.
struct SeenObstacle {
  FieldPoint center;
  Length radius;  ///< To its outermost edge, without any safety distance; > 0.
  friend constexpr bool operator==(const SeenObstacle&, const SeenObstacle&) = default;
};

/// One trip from the supply station and back: what to spray in between, in order.
struct SortieOrder {
  std::vector<Piece> pieces;  ///< At least one.
  StationId station;          ///< Where the sortie ends.
};

}  // namespace furrow
