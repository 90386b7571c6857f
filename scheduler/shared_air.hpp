#pragma once
// What sharing the air makes of a plan whose flights begin whenever they can.

#include "scheduler/fleet_plan.hpp"

namespace furrow::scheduler {

/// From one take-off at a place to the next: an aircraft that starts from rest is as far ahead as
/// tracks keep from each other, in the steps in which flights are put off [s].
double take_off_slot_s(const Vehicle& vehicle, Length separation);

/// Makespan of a plan where aircraft keep a distance in the air: from one home or station they take
/// off one by one, a slot apart, each as soon as it is ready and nobody has the place: who comes to
/// a station first chooses first, at homes in order of the plan. Bays are waited for as ever.
/// Waits for ways that cross in the air are not foreseen.
///
/// Time O(visits * (log aircraft + bays + take-offs of a station)).
///
/// @param separation  > 0.
/// @return            [s]; below the plan's own where a wait lets another to the bay first.
double shared_air_makespan_s(const FleetPlan& plan, Length separation);

}  // namespace furrow::scheduler
