#pragma once

#include "core/station.hpp"
#include "core/vehicle.hpp"
#include "core/work.hpp"
#include "planner/coverage/route.hpp"

#include <span>
#include <vector>

namespace furrow::scheduler {

/// An aircraft that can be given more work.
struct Survivor {
  Vehicle vehicle;  ///< Its home is where it will take off for the added work.
  Station station;  ///< Where its added sorties end, if they all end at one station.
  double ready_s;   ///< Mission time at which it can take off for them.
};

/// What one aircraft is given besides what it has.
struct Addition {
  std::vector<SortieOrder> sorties;  ///< Cells of the whole route; may be empty.
  double lands_s;                    ///< Forecast; `ready_s` where nothing is added.
  Station station;                   ///< Where the last of them ends; the survivor's if none.
};

/// Work without an owner, shared out.
struct Takeover {
  std::vector<Addition> additions;  ///< By survivor.
  std::vector<CellRange> nobodys;   ///< What no aircraft reaches, in order.
};

/// How much a search for the joint plan may do.
struct Effort {
  double budget_s = 1.0;  ///< Turned into a fixed count of work, as planner::SolveSettings.
  std::uint64_t seed = 1;
};

/// Shares `orphans` out so that the last survivor is done as early as can be.
///
/// First one run of whole strips each (of what is left of them), cut by bisection on the predicted
/// finish, as shares are, and flown with the better of the simple and the unplanned return points.
/// A survivor that cannot reach its run is left out, and all is cut again for the others. With that
/// the joint search begins (see joint_plan): for sorties from anywhere on what is left, to any of
/// the survivors' stations and of those besides, queues among them foreseen. Never later than what
/// it begins with.
///
/// Time O(survivors^2) cuts at worst, one where every survivor reaches all; and the search.
///
/// @param orphans   Cells of `route`: rising, apart; may be empty.
/// @param stations  Where sorties may end besides the survivors' stations; known ones count once.
Takeover take_over(const planner::Route& route, std::span<const CellRange> orphans,
                   std::span<const Survivor> survivors, const Effort& effort = {},
                   std::span<const Station> stations = {});

}  // namespace furrow::scheduler
