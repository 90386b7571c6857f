#pragma once

#include "app/results/flown.hpp"
#include "app/results/result.hpp"

#include <span>
#include <vector>

namespace furrow::app {

/// The sorties that a plan forecasts.
std::vector<SortieFigures> planned_sorties(const planner::Route& route,
                                           const scheduler::UavPlan& uav);

/// The sorties that an aircraft reported.
std::vector<SortieFigures> flown_sorties(const FlownUav& flown, const planner::Route& route,
                                         const scheduler::UavPlan& uav,
                                         std::span<const Station> stations);

/// Time of the returns among `sorties`: ways home and out again, waits and services [s].
double non_spray_s(const std::vector<SortieFigures>& sorties);

}  // namespace furrow::app
