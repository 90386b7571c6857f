#pragma once
// How the shares of a fleet are told apart in a picture.

#include "planner/coverage/route.hpp"
#include "scheduler/fleet_plan.hpp"

#include <string>
#include <vector>

namespace furrow::app {

/// A CSS colour per UAV.
using Colours = std::vector<std::string>;

/// Colours of the UAVs' shares. Shares that touch get different hues as far as there are hues;
/// UAVs of one hue get different shades of it, three at most.
Colours uav_colours(const planner::Route& route, const std::vector<scheduler::UavPlan>& uavs);

/// Where to write the name of each UAV: on a cell of its own in the middle of its largest piece of
/// land, and of every other piece of a quarter of its share or more.
std::vector<std::vector<FieldPoint>> label_places(const planner::Route& route,
                                                  const std::vector<scheduler::UavPlan>& uavs);

}  // namespace furrow::app
