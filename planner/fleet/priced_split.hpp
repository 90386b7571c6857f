#pragma once

#include "planner/fleet/problem.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace furrow::planner::fleet {

/// The path cut into sorties that are paid for by their flight times.
///
/// Flight times are told apart by levels: level j = 1 .. `levels()` - 1 is up to j `level_s`, the
/// highest is any. A sortie may pay the price of a higher level than its own.
/// All is at its least, for bounds: the fastest aircraft with the longest tank, from the nearest
/// place and to the nearest depot, cuts anywhere in cells, flights longer the longer the stretch.
class PricedSplit {
 public:
  /// @param level_s, cell_m  > 0.
  PricedSplit(const FleetProblem& problem, double level_s, double cell_m);

  std::size_t levels() const { return levels_; }

  /// By level: what its flights spray at most, in tanks, rising.
  const std::vector<double>& sprayed() const { return sprayed_; }

  /// Least sum of prices of sorties that spray the whole path.
  /// @param prices_by_level  Of levels 1, 2, ...; any sign is allowed.
  /// @param counts           So many sorties of each level are paid for; filled in.
  /// Time O(length / cell_m x levels).
  double least(std::span<const double> prices_by_level, std::span<double> counts);

 private:
  void tabulate(const FleetProblem& problem, double cell_m);
  void measure_sprayed();

  double level_s_;
  std::size_t levels_ = 0;
  /// Of leaving in cell i (0: at the path's begin) and of landing from cell i, on one clock.
  std::vector<double> leaves_s_, lands_s_;
  std::vector<double> begins_m_, ends_m_;  ///< Of the same, the first and the last position.
  double tank_m_ = 0.0;
  std::vector<double> sprayed_;
  std::vector<std::uint32_t> tank_from_;  ///< By cell: the first cell that a tank lasts from.
  std::vector<std::uint32_t> from_;       ///< By cell and level.
  std::vector<double> least_;
  std::vector<std::uint32_t> by_;  ///< By cell: the level that it was reached by.
};

}  // namespace furrow::planner::fleet
