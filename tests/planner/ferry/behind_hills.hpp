#pragma once
// Who flies from a station south of hills to the land north of them.

#include "core/vehicle.hpp"

namespace furrow::planner {

inline const FieldPoint station = at_m(200, -110);

inline const Vehicle aircraft{.id = AgentId{1},
                              .home = station,
                              .swath = metres(4),
                              .spray_speed = metres_per_second(3),
                              .ferry_speed = metres_per_second(6),
                              .spray_endurance = seconds(900),
                              .flight_endurance = seconds(1200),
                              .battery_reserve = 0,
                              .tank = litres(10),
                              .min_turn_radius = {},
                              .acceleration_limit = metres_per_second2(3),
                              .gnss = {}};

}  // namespace furrow::planner
