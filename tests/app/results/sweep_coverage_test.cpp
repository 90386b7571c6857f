#include "app/results/sweep_coverage.hpp"

#include "tests/app/results/small_mission.hpp"

#include <catch2/catch.hpp>

#include <numbers>

namespace furrow::app {
namespace {

Envelope said(Body body) {
  Envelope e{};
  e.body = std::move(body);
  return e;
}

// The small field sprayed in three rows, but for the middle of the second, where a tree of 0.5 m
// stands that is met.
MissionRecord met_tree() {
  MissionRecord record = small_plan();
  record.mode = Mode::sim;
  record.plan.sweep.emplace();
  ObstacleSeen seen{};
  seen.obstacle = {at_m(3, 4), metres(0.5)};
  record.log = {said(seen), said(seen), said(Event{"detour_closed", "flew around it"})};
  return record;
}

Flown flown_around() {
  Flown flown;
  flown.uavs.emplace_back();
  flown.uavs[0].track = {{Instant{}, at_m(1, 0), true}, {Instant{}, at_m(1, 8), false},
                         {Instant{}, at_m(3, 0), true}, {Instant{}, at_m(3, 3), false},
                         {Instant{}, at_m(3, 5), true}, {Instant{}, at_m(3, 8), false},
                         {Instant{}, at_m(5, 0), true}, {Instant{}, at_m(5, 8), false}};
  return flown;
}

TEST_CASE("sweep coverage: ground under an obstacle met in flight is not missed", "[app]") {
  MissionRecord record = met_tree();
  const Flown flown = flown_around();
  // 2 m of a swath of 2 m are dry, less the polygon of 32 corners around the tree.
  const double angle = std::numbers::pi / 32;
  const double tree_m2 = 32 * 0.25 * std::tan(angle);
  CHECK(sweep_areas(record, &flown).missed.base() == Approx(4 - tree_m2));
  CHECK(sweep_areas(record, &flown).covered.base() == Approx(48 - 4));
  record.log.clear();
  CHECK(sweep_areas(record, &flown).missed.base() == Approx(4));
}

TEST_CASE("sweep coverage: obstacles met count once, detours each", "[app]") {
  const MetFigures met = met_figures(met_tree().log);
  CHECK(met.obstacles == 1);
  CHECK(met.closed == 1);
  CHECK(met.detours == 0);
}

}  // namespace
}  // namespace furrow::app
