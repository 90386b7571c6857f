#pragma once
// A small mission for tests of the scheduler as a node.

#include "scheduler/scheduler_node.hpp"
#include "tests/scheduler/fixture.hpp"

namespace furrow::scheduler {

constexpr Instant at_s(int s) { return Instant{std::chrono::seconds{s}}; }

inline constexpr std::uint32_t strips = 6, cells_per_strip = 10;

inline FleetPlan plan() {
  FleetPlan p{.route = comb(strips, cells_per_strip),
              .work_direction_deg = 0,
              .uavs = {},
              .makespan_s = 0,
              .lower_bound_s = 0};
  p.uavs = {uav_plan(p.route, 1, {0, 3}, {4, 17}), uav_plan(p.route, 2, {3, 3}, {12}),
            uav_plan(p.route, 3, {6, 0}, {})};
  return p;
}

inline SchedulerSettings settings(std::chrono::seconds lease) {
  return {.plan = plan(),
          .epoch = Epoch{1},
          .agent_lease = lease,
          .mission_limit = std::chrono::seconds{600}};
}

/// A sortie for each strip. At one second two windows each are granted, so the third strips of both
/// are nobody's yet; whoever has them from the start is done with them at 100 s.
inline SchedulerSettings late_joiner() {
  SchedulerSettings s = settings(std::chrono::seconds{3});
  s.plan.uavs = {uav_plan(s.plan.route, 1, {0, 3}, {9, 19}),
                 uav_plan(s.plan.route, 2, {3, 3}, {9, 19}), uav_plan(s.plan.route, 3, {6, 0}, {})};
  s.plan.uavs[0].lands_s = s.plan.uavs[1].lands_s = 100;
  s.plan.uavs[2].joins_late = true;
  return s;
}

}  // namespace furrow::scheduler
