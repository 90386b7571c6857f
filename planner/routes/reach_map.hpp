#pragma once
// What it takes to fly from one place to every other over terrain.

#include "planner/routes/flight_cost.hpp"
#include "planner/routes/scene.hpp"

#include <cstdint>
#include <vector>

namespace furrow::planner {

/// How fast an aircraft flies, and what climbing costs it; all > 0 unless said.
struct AirSpeeds {
  double level_mps;
  double climb_mps, descent_mps;
  double climb_energy_s_per_m =
      0;  ///< Pack used for a metre of climb, in seconds of level flight; >= 0.
};

/// Of the straight line from `a` to `b`: as long as its length, climb or descent takes, whichever
/// takes longest.
FlightCost flight_cost(WayPoint a, WayPoint b, const AirSpeeds& speeds);

/// Quickest ways from the scene's start to the cells of a grid over its box, down to the clearance
/// over each cell's middle: by straight legs between places of a lattice (lazy Theta*).
///
/// Set-up: one pass over the lattice for all cells; 0.4 s for 10 000 cells by 10 levels.
/// Source: Nash, Koenig, Tovey 2010, AAAI, 147-154 (lazy Theta*).
class ReachMap {
 public:
  /// @param columns, rows, levels  Of the lattice, each >= 2; a cell is a column of it.
  /// Keeps no reference. The scene's goal and limits are not used.
  ReachMap(const Scene& scene, const AirSpeeds& speeds, std::uint32_t columns, std::uint32_t rows,
           std::uint32_t levels);

  std::size_t cells() const { return best_.size(); }
  /// The cell whose middle is nearest to a place.
  std::size_t cell(double x_m, double y_m) const;
  bool is_reached(std::size_t cell) const { return best_[cell] >= 0; }

  /// @pre is_reached(cell)
  FlightCost out(std::size_t cell) const { return out_[cell]; }
  FlightCost back(std::size_t cell) const { return back_[cell]; }
  /// Corners from the start to the clearance over the cell's middle; reversed, the way back.
  std::vector<WayPoint> way(std::size_t cell) const;

 private:
  WayPoint low_, pitch_;
  std::uint32_t columns_, rows_;
  WayPoint start_;
  std::vector<WayPoint> goals_;  // of each cell
  std::vector<int> best_;        // node that the way to a cell comes down from, or -1
  std::vector<int> from_;        // of each node; -1: the start
  std::vector<FlightCost> out_, back_;
};

}  // namespace furrow::planner
