#pragma once

#include "planner/coverage/swath/inset.hpp"
#include "planner/coverage/swath/order.hpp"
#include "planner/coverage/swath/settings.hpp"

#include <optional>
#include <vector>

namespace furrow::planner {

/// A connected piece of flight area, cut into ordered strips.
struct PartPlan {
  std::vector<StripGroup> groups;
  StripOrder order;
  RowFrame direction{1, 0};  ///< Of the rows; of the largest cell where cells differ.
  double dropped_m2 = 0;
  double cost_m = 0;  ///< Route plus turns at their price.
};

/// What all pieces of a field share.
struct PlanRule {
  double swath_m;
  double margin_m;
  SwathSettings settings;
  std::optional<PointM> start;
};

/// Directions for the rows of `pieces`, the most promising first: every degree of the half circle
/// (the other half flies the same rows) and the longer edges, by length, turns and leaps.
std::vector<RowFrame> ranked_directions(const LandParts& pieces, const PlanRule& rule,
                                        std::size_t most);

/// Covers `piece` with rows in one direction. `flight` is the connected area that holds it.
PartPlan plan_one_direction(const LandPart& piece, const LandPart& flight, const LandParts& land,
                            const InsidePaths& paths, RowFrame direction, const PlanRule& rule,
                            const std::vector<StripGroup>& first);

/// Covers `piece` in the direction, or with the cells and a direction for each, that cost least.
PartPlan plan_best(const LandPart& piece, const LandPart& flight, const LandParts& land,
                   const InsidePaths& paths, const PlanRule& rule,
                   const std::vector<StripGroup>& first);

}  // namespace furrow::planner
