#pragma once

#include "scheduler/fleet_plan.hpp"

#include <optional>

namespace furrow::scheduler {

/// Where the ground is steeper than an aircraft climbs or descends even at its least speed over it.
/// The height that it is to keep is not kept there.
struct Steep {
  double length_m = 0;
  std::optional<FieldPoint> first{};  ///< Where the first piece of it begins, in order flown.
};

struct SteepWays {
  Steep rows;     ///< Valve open; the height is that of work.
  Steep between;  ///< From row to row, and from and to stations.
};

/// Of all that a plan has its aircraft fly, by the pieces in which they follow the ground (see
/// planner::Relief::too_steep_m). Nothing on level land.
SteepWays steep_ways(const FleetPlan& plan);

}  // namespace furrow::scheduler
