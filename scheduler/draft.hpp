#pragma once

#include "scheduler/forecast.hpp"
#include "scheduler/partition.hpp"

#include <span>
#include <vector>

namespace furrow::scheduler {

/// A fleet's shares and stations, with the forecast that they were chosen by.
struct Draft {
  std::vector<Share> shares;  ///< By aircraft.
  Forecast forecast;          ///< Of return points that are best without batteries and queues.
};

/// Cuts the route by predicted finish and gives each aircraft a station.
///
/// The cut is made again a few times with the battery swaps and the queues that the forecast of the
/// last cut has shown, and stations are changed where that shortens the mission or its queues; the
/// draft with the smallest forecast makespan is kept.
///
/// @pre A tank of every aircraft lasts for one cell.
Draft draft(const planner::Route& route, const RouteLengths& lengths,
            std::span<const Vehicle> vehicles, std::span<const Station> stations);

}  // namespace furrow::scheduler
