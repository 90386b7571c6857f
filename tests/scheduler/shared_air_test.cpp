#include "scheduler/shared_air.hpp"

#include "scheduler/forecast.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

UavPlan plan_of(std::uint32_t id, std::vector<Visit> visits, double spray_ends_s) {
  Vehicle v = vehicle(id);
  v.acceleration_limit = metres_per_second2(3);
  return {.vehicle = v,
          .station = station(1, 2),
          .strips = {},
          .cells = {},
          .solution = {},
          .visits = std::move(visits),
          .spray_ends_s = spray_ends_s,
          .lands_s = spray_ends_s + 5};
}

FleetPlan fleet_of(std::vector<UavPlan> uavs) {
  FleetPlan plan{.route = {},
                 .work_direction_deg = 0,
                 .uavs = std::move(uavs),
                 .makespan_s = 0,
                 .lower_bound_s = 0};
  for (const UavPlan& uav : plan.uavs) {
    plan.makespan_s = std::max(plan.makespan_s, uav.spray_ends_s);
  }
  return plan;
}

TEST_CASE("shared air: who takes off from one place does so a slot after the one before",
          "[scheduler]") {
  // 1 m and 1.5 m of room at 0.95 x 3 m/s2 take sqrt(2 x 2.5 / 2.85) = 1.32 s: 1.5 s in steps.
  CHECK(take_off_slot_s(plan_of(1, {}, 1).vehicle, metres(1)) == 1.5);
  const FleetPlan plan = fleet_of({plan_of(1, {}, 100), plan_of(2, {}, 100), plan_of(3, {}, 99)});
  CHECK(shared_air_makespan_s(plan, metres(1)) == Approx(102));  // the third begins at 3 s
}

TEST_CASE("shared air: take-offs after service wait for those just before them", "[scheduler]") {
  // Both are ready at 70 s. The second began its mission at 1.5 s, so it comes at 41.5 s, is ready
  // at 71.5 s and has the pad then; it sprays 50 s from there.
  const Visit visit{.arrives_s = 40, .starts_s = 40, .ready_s = 70, .bay = 1};
  const FleetPlan both = fleet_of({plan_of(1, {visit}, 120), plan_of(2, {visit}, 120)});
  CHECK(shared_air_makespan_s(both, metres(1)) == Approx(121.5));
  // Where the first is served until 71.5 s, the second gets the slot after it.
  const Visit longer{.arrives_s = 40, .starts_s = 40, .ready_s = 71.5, .bay = 1};
  const FleetPlan one = fleet_of({plan_of(1, {longer}, 120), plan_of(2, {visit}, 120)});
  CHECK(shared_air_makespan_s(one, metres(1)) == Approx(123));
}

TEST_CASE("shared air: one aircraft is done as planned", "[scheduler]") {
  const Visit visit{.arrives_s = 40, .starts_s = 40, .ready_s = 70, .bay = 1};
  CHECK(shared_air_makespan_s(fleet_of({plan_of(1, {visit}, 120)}), metres(1)) == Approx(120));
}

}  // namespace
}  // namespace furrow::scheduler
