#pragma once

#include "agents/conduct/surroundings.hpp"
#include "agents/guidance/height_profile.hpp"
#include "agents/guidance/path.hpp"
#include "core/vehicle.hpp"
#include "core/work.hpp"
#include "planner/ferry/ferry_map.hpp"

#include <optional>
#include <span>
#include <vector>

namespace furrow::agents {

/// A piece laid on a path. Lengths without "leg" are along the smoothed path [m].
struct PieceOnPath {
  Piece piece;
  double open_m, close_m;        ///< The valve may be open between.
  double from_leg_m, spacing_m;  ///< First cell, and from cell to cell, along the legs.
  double from_m;                 ///< First cell.
  /// Where the piece is flown around obstacles: by cell, where its centre is abeam, along the path;
  /// and the stretch off its line. A cell there counts when it is passed abeam.
  std::vector<double> abeam_m{};
  double bends_from_m = 0.0, bends_to_m = 0.0;
  /// Where the valve is closed on the way around, in order.
  struct Closed {
    double from_m, to_m;
  };
  std::vector<Closed> closed{};

  /// Whether the valve may be open there.
  bool is_sprayed(double along_m) const;
  /// How much is sprayed between.
  double sprayed_m(double begin_m, double end_m) const;
  /// The last place after `begin_m` and up to `end_m` where the valve moves; `end_m` without one.
  double valve_moves_m(double begin_m, double end_m) const;

  /// Whether it is flown around an obstacle there.
  bool is_beside_its_line(double along_m) const {
    return is_bent() && along_m > bends_from_m && along_m < bends_to_m;
  }

  bool is_bent() const { return !abeam_m.empty(); }

  /// Whether the valve stays open beyond the centre of the last cell.
  bool has_tail() const { return !(piece.exit == piece.to); }
};

/// A way that is not work: from a station or from work to other work or to a station.
struct Way {
  std::size_t to_piece;     ///< That it leads to; the number of pieces: to the station.
  double begins_m, ends_m;  ///< Along the path.
};

/// A sortie from where the aircraft is, over its pieces, to the station.
struct SortieRoute {
  Path path;
  std::vector<PieceOnPath> pieces;
  double spray_m;           ///< Valve open.
  std::vector<Way> ways{};  ///< In order; the last leads to the station.
  HeightProfile heights{};  ///< Over terrain, along the path.
  /// Where along the path an obstacle blocks it: nothing from there on may be flown. None: nowhere.
  std::optional<double> blocked_m{};
  bool leaves_land = false;  ///< Around an obstacle, where no way on the land leads past it.

  /// Where along the path cell `index` of piece `piece` has its centre [m].
  double cell_m(std::size_t piece, std::uint32_t index) const;
};

/// The route over `pieces`, which may be empty: then straight to `to`. Ferries are flown at ferry
/// speed with the valve closed, by the pieces' approaches but for the first.
///
/// Corners are cut by at most half a swath: so far inside a corner the path leaves the polyline,
/// and nowhere else. Where that would cost land or leave it, they are not: a piece sprayed from end
/// to end begins and ends at a stop, and way points of approaches, which bend around edges, are
/// held.
///
/// Over terrain the route keeps work height on pieces and between them, ferries as
/// planner::Relief::ferry says, and is flown no faster than its slopes allow.
///
/// Legs lead around what was seen, in plan: pieces with the valve open, all others as
/// `Surroundings::ferry_bends` says; no corner is cut near to it. Over terrain such ways get
/// heights as all others do, but for approaches that name heights of their own, which stay as they
/// are. Where there is no way around, the route is blocked 0.5 m before the clearance. It is the
/// same route up to the first leg that an obstacle learnt since changes.
///
/// @param begins  Altitude of an aircraft that is in the air already, over terrain.
SortieRoute sortie_route(Xy from_m, std::span<const Piece> pieces, Xy to_m, const Vehicle& vehicle,
                         const planner::FerryMap& ferries, const Surroundings& around,
                         std::optional<Length> begins = {});

/// Lifts the ways of a route over level land to `layer`. They climb out and come down on the way at
/// ferry speed, so no flight takes longer.
/// @param begins  Height at which the route begins.
void lift_ferries(SortieRoute& route, Length layer, Length begins, const Vehicle& vehicle,
                  const planner::HeightRule& rule);

/// What a ferry takes of a pack, in metres of level flight at ferry speed; without braking.
double ferry_pack_m(FieldPoint from, FieldPoint to, const Vehicle& vehicle,
                    const planner::FerryMap& ferries);

/// Time for a straight way from rest to rest at ferry speed [s].
double straight_way_s(double length_m, const Vehicle& vehicle);

}  // namespace furrow::agents
