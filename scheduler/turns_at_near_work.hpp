#pragma once
// Plans in which aircraft are not at the same time on strips nearer to each other than they keep.

#include "scheduler/joint_plan.hpp"

namespace furrow::scheduler {

/// For how long, in all, two aircraft of a plan are at the same time on strips that are nearer to
/// each other than `near`: so long one of them will wait, or longer [s]. Where an aircraft is
/// within a flight is foreseen by the share of its cells that it has sprayed, to a quarter of a
/// minute. Not counted are parts of one strip, which are near at their ends only.
/// @param whole  The route that `flown` is on.
double waits_at_near_work_s(const FlownLists& flown, const planner::Route& whole, Length near);

/// The same lists with flights in another order, where aircraft would wait for each other and less
/// is lost by it. Flights change their place within their aircraft's list, one after another; each
/// time the one whose change makes makespan and waits least. A hundred forecasts at most.
///
/// @param flown    Of `joint_plan`, on `whole` with these stations.
/// @param near     > 0.
FlownLists turned_at_near_work(FlownLists flown, const planner::Route& whole,
                               const RouteLengths& lengths, std::span<const Vehicle> vehicles,
                               std::span<const Station> stations, Length near);

}  // namespace furrow::scheduler
