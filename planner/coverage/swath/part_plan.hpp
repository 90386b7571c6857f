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
  bool along_edge = true;    ///< Whether the rows run along an edge of the field.
  double dropped_m2 = 0;
  double missed_m2 = 0;  ///< Land that no strip covers; an estimate until the plan is finished.
};

/// What all pieces of a field share.
struct PlanRule {
  double swath_m;  ///< Between rows: less than the boom where they overlap.
  double boom_m;
  double margin_m;
  SwathSettings settings;
  std::optional<PointM> start;
};

/// Directions to choose from.
struct RowDirection {
  RowFrame frame;
  bool along_edge;
};

/// What a plan costs, in metres flown: its route, its turns at their price, and twice the row that
/// land left out would take, so that no plan wins by leaving land out. Rows along no edge must save
/// one part in a hundred.
double cost_m(const PartPlan& plan, const PlanRule& rule);

/// Orders the groups of `plan` within `flight` and estimates what they miss.
void put_in_order(PartPlan& plan, const LandPart& flight, const InsidePaths& paths,
                  const PlanRule& rule);

/// Directions for the rows of `pieces`, the most promising first: every degree of the half circle
/// (the other half flies the same rows) and the longer edges, by length, turns and leaps.
std::vector<RowDirection> ranked_directions(const LandParts& pieces, const PlanRule& rule,
                                            std::size_t most);

/// Covers `piece` with rows in one direction. `flight` is the connected area that holds it.
PartPlan plan_one_direction(const LandPart& piece, const LandPart& flight, const LandParts& land,
                            const InsidePaths& paths, RowDirection direction, const PlanRule& rule,
                            const std::vector<StripGroup>& first);

/// Covers `piece` in the most promising directions, and with the cells and a direction for each of
/// the most promising cuts; the cheapest plan first, at least one.
std::vector<PartPlan> ranked_plans(const LandPart& piece, const LandPart& flight,
                                   const LandParts& land, const InsidePaths& paths,
                                   const PlanRule& rule, const std::vector<StripGroup>& first);

}  // namespace furrow::planner
