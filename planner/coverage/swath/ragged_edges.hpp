#pragma once

#include "planner/coverage/swath/areas.hpp"
#include "planner/coverage/swath/groups.hpp"

#include <vector>

namespace furrow::planner {

/// What edge strips add to rows.
struct EdgeStrips {
  std::vector<StripGroup> groups;
  double missed_m2;  ///< Land that neither rows nor these strips spray.
};

/// Strips along those edges at which rows leave the most land out, until at most
/// `tolerance` of the land is missed or no edge strip helps.
///
/// Where rows meet an edge at a slant, they leave a saw of triangles; where the land ends between
/// two rows, a thin band. One strip along the edge covers either; along a curve, a chain of them.
///
/// @param flight   Where strips may lie.
/// @param sprayed  What is sprayed already.
/// @param least_m  Shorter edge strips are not worth flying.
EdgeStrips edge_strips(const LandPart& flight, const LandParts& land,
                       const std::vector<SprayedRun>& sprayed, double swath_m, double tolerance,
                       double least_m);

}  // namespace furrow::planner
