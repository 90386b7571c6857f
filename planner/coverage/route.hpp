#pragma once

#include "core/geometry.hpp"
#include "core/work.hpp"
#include "planner/ferry/ferry_map.hpp"

#include <optional>
#include <span>
#include <vector>

namespace furrow::planner {

/// A straight run of cells, flown in one go in any direction. Its cells divide it equally; `from`
/// and `to` are the centres of its end cells.
///
/// The valve is open from `begin` over `from` and `to` to `end`. Where cells are sprayed from
/// centre to centre (grid), begin == from and end == to; where a strip is sprayed from end to end
/// (swath), they lie half a cell beyond.
struct Strip {
  CellRange cells;
  FieldPoint from, to;
  FieldPoint begin, end;
  /// Whether the way here from the strip before is a single sprayed move between neighbouring
  /// cells; otherwise it is a ferry with the valve closed. False for the first strip.
  bool continues;
  /// Way points of that ferry between the end of the strip before and `begin`; none: straight.
  std::vector<FieldPoint> approach{};
  /// Of these, above the datum [m]; none: as high as strips are flown.
  std::vector<double> approach_altitudes_m{};
  Length width{};  ///< Of the spray, where only a part of the boom is open; 0: all of it.
  /// Where it is the rest of a strip that another sortie begins: the centre of the cell before it.
  /// Where cells are sprayed from centre to centre the valve opens there.
  std::optional<FieldPoint> joins{};
};

/// A strip that is sprayed from centre to centre of its cells.
inline Strip centre_strip(CellRange cells, FieldPoint from, FieldPoint to, bool continues) {
  return {cells, from, to, from, to, continues, {}, {}, {}, {}};
}

/// A strip of `cells` that is sprayed from end to end, reached with the valve closed.
/// @param cells  At least one.
Strip end_strip(CellRange cells, FieldPoint begin, FieldPoint end,
                std::vector<FieldPoint> approach);

/// Longer ways between strips are flown as ferries are: above those at work, in a layer.
inline constexpr Length longest_low_way = metres(20);

/// Whether a way between strips is longer than that.
/// @param way  From where it starts to where it ends.
bool is_high(std::span<const FieldPoint> way);

/// Whether the way from one piece to the next of a sortie leads beyond the neighbouring strip: it
/// is longer than 10 m, or leads away from the line of the piece by more than one and a half
/// swaths, so past the end of a row that another may be at. Never between places to visit.
bool are_apart(const Piece& before, const Piece& after, Length swath);

/// Whether the strip is sprayed beyond the centres of its end cells.
inline bool sprays_ends(const Strip& strip) {
  return !(strip.begin == strip.from && strip.end == strip.to);
}

/// What ways around obstacles add to a straight strip, metres.
struct MetDetour {
  double longer_m = 0;
  double sprayed_m = 0;  ///< Below zero where the valve is closed.
  friend MetDetour operator+(MetDetour a, MetDetour b) {
    return {a.longer_m + b.longer_m, a.sprayed_m + b.sprayed_m};
  }
};

/// The order in which a field is covered: where every coverage model ends and all further planning
/// starts.
struct Route {
  Length cell;                      ///< Nominal side of a cell: the swath; 0 on a survey.
  std::vector<FieldPoint> centers;  ///< N cells in the order flown, N >= 1.
  std::vector<Strip> strips;        ///< Contiguous, in order; together all N cells.
  std::vector<FieldPoint> missed;   ///< Centres of workable cells that the route leaves out.
  FerryMap ferries{};               ///< The ways between stations and strips.
  /// By cell: around obstacles that were met in flight and begin there; empty: nowhere.
  std::vector<MetDetour> detours{};
};

/// Whether the strips are places to visit, each with one cell of no length: nothing is sprayed.
inline bool is_survey(const Route& route) { return route.cell == Length{}; }

/// A route along `strips`, cells and centres filled in: each strip is divided into as many equal
/// cells as come closest to `cell`.
/// @param strips  Their `begin`, `end` and `approach` count, not empty, none without length.
Route end_to_end_route(Length cell, std::vector<Strip> strips);

/// Index of the strip that holds `cell`. @pre The route has that cell.
std::size_t strip_of(const Route& route, std::uint32_t cell);

/// Where an aircraft that returns after `cell` has stopped spraying: the centre of the cell in a
/// strip sprayed from centre to centre, else the far edge of the cell.
FieldPoint stop_point(const Route& route, const Strip& strip, std::uint32_t cell);

/// Where spraying of `cell` begins if the cell before was sprayed on another sortie.
FieldPoint start_point(const Route& route, const Strip& strip, std::uint32_t cell);

/// Where work goes on after a return that followed `cell`: at the beginning of the next strip if
/// the cell ended its strip and a ferry would follow, else where it stopped.
FieldPoint resume_point(const Route& route, std::uint32_t cell);

/// Length sprayed per cell: the nominal one from centre to centre, else that of the strip.
Length cell_length(const Route& route, const Strip& strip);

/// The same for every cell, metres.
std::vector<double> cell_lengths_m(const Route& route);

/// Length of the ferry from the end of `before` to the beginning of `strip`.
Length approach_length(const Strip& before, const Strip& strip);

/// Way points of the shortest ferry over `ferries` from the end of `before` to the beginning of
/// `strip`.
std::vector<FieldPoint> approach_over(const FerryMap& ferries, const Strip& before,
                                      const Strip& strip);

/// A cell as something to return after, in metres.
struct CellStop {
  FieldPoint stop;    ///< Where the valve closes when the aircraft returns after this cell.
  FieldPoint resume;  ///< See `resume_point`; within the range.
  double spray_m;     ///< Sprayed from the start of the range up to `stop`.
  double approach_m;  ///< Ferried from the cell before to this one; 0 within a strip.
  double skipped_m;   ///< Of the next approach, what a return after this cell saves.
  double dry_m = 0;   ///< Flown on strips from the start of the range, the valve closed.
};

/// The stops of `cells`, as if their first were the first of a share.
/// @pre `cells` is not empty and within the route.
std::vector<CellStop> cell_stops(const Route& route, CellRange cells);

}  // namespace furrow::planner
