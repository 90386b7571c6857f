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
  FlownUav& uav = flown.uavs.emplace_back();
  const auto fly = [&](double x_m, double from_m, double to_m) {
    uav.track.push_back({Instant{}, at_m(x_m, from_m), true});
    uav.track.push_back({Instant{}, at_m(x_m, to_m), false});
  };
  fly(1, 0, 8);
  fly(3, 0, 3);
  fly(3, 5, 8);
  fly(5, 0, 8);
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
