#pragma once

#include "core/vehicle.hpp"
#include "planner/coverage/route.hpp"

namespace furrow::planner {

/// How much longer it takes to fly from the end of `before` to the beginning of `next`, as aircraft
/// brake, turn and gather speed, than at the constant speeds of strip and ferry [s]. Corners are
/// those of the agents: stops at the ends of strips sprayed from end to end, held corners on
/// approaches and where strips meet, else cut ones.
double joint_loss_s(const Strip& before, const Strip& next, const Vehicle& vehicle);

/// The same of coming from rest at a station to the speed of work on `strip`, or back to rest.
double ferry_loss_s(const Strip& strip, const Vehicle& vehicle);

}  // namespace furrow::planner
