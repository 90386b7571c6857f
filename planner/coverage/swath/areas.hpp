#pragma once

#include "core/units.hpp"
#include "planner/coverage/plane.hpp"

#include <vector>

namespace furrow::planner {

/// What became of the land, from the union of footprints. covered + missed is the land, and
/// covered + outside + repeated is sprayed.
struct SprayedAreas {
  Area sprayed;   ///< Length times width of all runs, and the outer wedges of their bends.
  Area covered;   ///< Land sprayed at least once.
  Area missed;    ///< Land never sprayed.
  Area repeated;  ///< Sprayed again, counted each further time.
  Area outside;   ///< Not land, but sprayed.
};

/// A flown way while the valve was open, widened to `width_m`.
struct SprayedRun {
  PathM path;  ///< At least one place; fewer than two spray nothing.
  double width_m;
};

/// The areas of `runs` over `land`. A run is its path widened by half the width to each side:
/// square at its ends, round where it bends.
SprayedAreas sprayed_areas(const std::vector<SprayedRun>& runs, const LandParts& land);

/// The places that no run covers.
LandParts missed_land(const std::vector<SprayedRun>& runs, const LandParts& land);

}  // namespace furrow::planner
