#include "core/random.hpp"
#include "planner/coverage/plane.hpp"
#include "scheduler/sketch.hpp"
#include "tests/scheduler/fixture.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>

namespace furrow::scheduler {
namespace {

constexpr double safety_m = 1.5, swath_m = 6;
constexpr double kept = 1 - 1e-5;  // but for rounding

planner::PointM plane(FieldPoint p) { return {p.x.base(), p.y.base()}; }

// A ring of 3 to 9 corners around a place; not always convex.
Obstacle outline(Random& random, std::string id, FieldPoint middle, double widest_m) {
  const double corners = 3 + static_cast<double>(random.below(7));
  const double first = random.uniform(0, 2 * std::numbers::pi);
  Ring ring;
  for (double i = 0; i < corners; ++i) {
    const double angle = first + 2 * std::numbers::pi * i / corners;
    const double far_m = random.uniform(0.4, 1) * widest_m;
    ring.push_back(middle +
                   FieldVector{metres(far_m * std::cos(angle)), metres(far_m * std::sin(angle))});
  }
  return outlined(std::move(id), std::move(ring));
}

// Trees and outlines on 60 x 120 m with or without a corner cut out, and zones that nobody may fly
// over between it and the station, 40 m south of it.
FleetProblem scene(std::uint64_t seed) {
  Random random{seed};
  FleetProblem p;
  p.field.boundary = {at_m(0, 0), at_m(60, 0), at_m(60, 120), at_m(0, 120)};
  if (seed % 3 == 0) {
    p.field.boundary = {at_m(0, 0),   at_m(60, 0),   at_m(60, 80),
                        at_m(40, 80), at_m(40, 120), at_m(0, 120)};
  }
  for (std::uint64_t i = random.below(12); i > 0; --i) {
    const FieldPoint at = at_m(random.uniform(-5, 65), random.uniform(-5, 125));
    p.field.obstacles.push_back(
        {"tree" + std::to_string(i), at, metres(random.uniform(0.3, i == 1 ? 15 : 3))});
  }
  for (std::uint64_t i = random.below(3); i > 0; --i) {
    const FieldPoint at = at_m(random.uniform(0, 60), random.uniform(0, 120));
    p.field.obstacles.push_back(
        outline(random, "outline" + std::to_string(i), at, random.uniform(1, 20)));
  }
  for (std::uint64_t i = random.below(3); i > 0; --i) {
    const FieldPoint at = at_m(random.uniform(0, 60), random.uniform(-30, -10));
    p.field.obstacles.push_back(
        outline(random, "zone" + std::to_string(i), at, random.uniform(3, 15)));
  }
  std::optional<planner::AvoidanceSettings> avoidance;
  if (seed % 5 > 0) {  // else obstacles end rows
    avoidance = {.safety = metres(safety_m), .turn_radius = metres(3)};
    avoidance->iterations = 10;
    avoidance->dubins_turns = seed % 4 == 1;
  }
  planner::SwathSettings rows;
  planner::CoverageSettings walk;
  rows.avoidance = walk.avoidance = avoidance;
  rows.safety = walk.safety = metres(safety_m);
  if (seed % 2 == 0) {
    p.coverage = rows;
  } else {
    p.coverage = walk;
  }
  p.work_direction_deg = 0;
  p.stations = {station(1, 1, at_m(30, -40))};
  p.vehicles = {vehicle(1)};
  p.vehicles.front().swath = metres(swath_m);
  p.vehicles.front().home = p.stations.front().position;
  return p;
}

double clear_m(FieldPoint from, FieldPoint to, const Obstacle& o) {
  const planner::PointM a = plane(from), b = plane(to);
  if (o.outline.empty()) return planner::distance_m(plane(o.center), a, b) - o.radius.base();
  if (depth_in(o, from) > Length{}) return -depth_in(o, from).base();
  double least = INFINITY;
  for (std::size_t i = 0; i < o.outline.size(); ++i) {
    const FieldPoint next = o.outline[(i + 1) % o.outline.size()];
    least = std::min(least, planner::apart_m(a, b, plane(o.outline[i]), plane(next)));
  }
  return least;
}

// The least distance of any leg, as a share of the safety distance, and what came of the scenes.
struct Clearances {
  double rows = INFINITY, connections = INFINITY, ferries = INFINITY;
  std::size_t planned = 0, legs = 0;
  std::map<planner::PlanFault, std::size_t> refused{};

  void judge(const FleetProblem& p) {
    const auto made = best_sketch(p);
    if (!made) {
      CHECK_FALSE(made.error().detail.empty());
      ++refused[made.error().fault];
      return;
    }
    ++planned;
    const planner::Route& route = made->coverage.route;
    const FieldPoint at = p.stations.front().position;
    for (std::size_t i = 0; i < route.strips.size(); ++i) {
      const planner::Strip& s = route.strips[i];
      take(rows, {s.begin, s.end}, p.field);
      take(ferries, route.ferries.way(at, s.begin), p.field);
      take(ferries, route.ferries.way(s.end, at), p.field);
      if (i == 0) continue;
      std::vector<FieldPoint> way{route.strips[i - 1].end};
      way.insert(way.end(), s.approach.begin(), s.approach.end());
      way.push_back(s.begin);
      take(connections, way, p.field);
    }
  }

 private:
  void take(double& least, const std::vector<FieldPoint>& way, const Field& field) {
    for (std::size_t i = 1; i < way.size(); ++i) {
      ++legs;
      for (const Obstacle& o : field.obstacles) {
        least = std::min(least, clear_m(way[i - 1], way[i], o) / safety_m);
      }
    }
  }
};

Clearances of_scenes(std::uint64_t count, bool verbose) {
  Clearances all;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const double before = std::min({all.rows, all.connections, all.ferries});
    all.judge(scene(seed));
    const double after = std::min({all.rows, all.connections, all.ferries});
    if (verbose && after < before && after < 1) {
      std::cout << "scene " << seed << ": " << all.rows << ' ' << all.connections << ' '
                << all.ferries << '\n';
    }
  }
  std::cout << count << " scenes: " << all.planned << " planned, " << all.legs
            << " legs; least distance by the safety distance: rows " << all.rows << ", connections "
            << all.connections << ", ferries " << all.ferries << "; refused:";
  for (const auto& [fault, n] : all.refused) {
    std::cout << ' ' << n << " by fault " << static_cast<int>(fault);
  }
  std::cout << '\n';
  return all;
}

}  // namespace

TEST_CASE("random scenes of trees, outlines and zones keep every leg clear or are refused") {
  const Clearances all = of_scenes(70, true);
  CHECK(all.planned > 30);
  CHECK(all.rows >= kept);
  CHECK(all.connections >= kept);
  CHECK(all.ferries >= kept);
}

TEST_CASE("ten thousand random scenes of trees, outlines and zones keep every leg clear",
          "[.][sweep]") {
  const Clearances all = of_scenes(10'000, true);
  CHECK(all.rows >= kept);
  CHECK(all.connections >= kept);
  CHECK(all.ferries >= kept);
}

}  // namespace furrow::scheduler
