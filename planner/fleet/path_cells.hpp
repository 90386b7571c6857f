#pragma once
// A path cut into short cells, for bounds that hold wherever sorties end.

#include "planner/fleet/problem.hpp"

#include <cstddef>
#include <vector>

namespace furrow::planner::fleet {

/// Cell i holds the positions above `begin_m(i)` up to `end_m(i)`, all on strip `strip(i)`.
class PathCells {
 public:
  /// @param cell_m  No cell is longer, > 0.
  PathCells(const StripPath& path, double cell_m);

  std::size_t size() const { return strips_.size(); }
  double begin_m(std::size_t i) const { return ends_m_[i]; }
  double end_m(std::size_t i) const { return ends_m_[i + 1]; }
  std::uint32_t strip(std::size_t i) const { return strips_[i]; }

 private:
  std::vector<double> ends_m_;  ///< From 0.
  std::vector<std::uint32_t> strips_;
};

/// Where aircraft leave from, at depots and at starts, each place once.
std::vector<FieldPoint> places_to_leave(const FleetProblem& problem);

}  // namespace furrow::planner::fleet
