#include "planner/avoidance/walk_around.hpp"

#include "planner/coverage/cover.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

using namespace furrow;
using namespace furrow::planner;

namespace {

// 15 columns of 25 cells of 4 m.
Field orchard(std::vector<Obstacle> trees) {
  return {{at_m(0, 0), at_m(60, 0), at_m(60, 100), at_m(0, 100)}, {}, std::move(trees)};
}

CoverageSettings settings() {
  CoverageSettings s;
  s.near = at_m(0, 0);
  s.avoidance.emplace();
  s.avoidance->safety = metres(1.5);
  s.avoidance->turn_radius = metres(2);
  return s;
}

double nearest_m(const Route& route, FieldPoint place) {
  PathM path;
  const auto go = [&](FieldPoint p) { path.push_back({p.x.base(), p.y.base()}); };
  for (const Strip& s : route.strips) {
    for (const FieldPoint p : s.approach) go(p);
    go(s.begin);
    go(s.end);
  }
  return distance_m({place.x.base(), place.y.base()}, path);
}

}  // namespace

TEST_CASE("a walk without obstacles on its way stays the walk it was") {
  const Field field = orchard({{"aside", at_m(70, 50), metres(1)}});
  const auto walk = coverage_route(field, metres(4), settings());
  const auto around = walk_around(field, metres(4), settings());
  REQUIRE(walk);
  REQUIRE(around);
  CHECK(around->leaps.empty());
  CHECK(around->route.centers == walk->centers);
  REQUIRE(around->route.strips.size() == walk->strips.size());
  for (std::size_t i = 0; i < walk->strips.size(); ++i) {
    CHECK(around->route.strips[i].cells == walk->strips[i].cells);
    CHECK(around->route.strips[i].continues == walk->strips[i].continues);
    CHECK_FALSE(sprays_ends(around->route.strips[i]));
  }
}

TEST_CASE("a walk flies around a small tree, and misses less than the cells that it covers") {
  // On the line of the second column, x = 6, and in two of its cells: 2 16 m2 where they are left
  // out.
  const Field field = orchard({{"tree", at_m(6.3, 48), metres(0.5)}});
  const auto around = walk_around(field, metres(4), settings());
  REQUIRE(around);
  const AvoidanceRecord& record = around->rows.record;
  CHECK(record.planned.detours == 1);
  CHECK(record.planned.missed.base() + record.planned.repeated.base() < 32);
  CHECK(nearest_m(around->route, at_m(6.3, 48)) >= 0.5 + 1.5 - 1e-5);
  // Only the pass that meets it changes, and the steps at both its ends: of 15 columns 14 stay.
  const auto& strips = around->route.strips;
  CHECK(std::count_if(strips.begin(), strips.end(),
                      [](const Strip& s) { return !sprays_ends(s); }) == 14);
}

TEST_CASE("strips of a walk around trees follow one another, each cell once") {
  const Field field = orchard({{"a", at_m(6.3, 48), metres(0.5)},
                               {"end", at_m(22, 98), metres(0.5)},
                               {"wide", at_m(42, 60), metres(5)}});
  const auto around = walk_around(field, metres(4), settings());
  REQUIRE(around);
  const Route& route = around->route;
  std::uint32_t next = 0;
  for (const Strip& s : route.strips) {
    CHECK(s.cells.first == next);
    CHECK(s.cells.count > 0);
    CHECK(route.centers[s.cells.first] == s.from);
    CHECK(route.centers[end(s.cells) - 1] == s.to);
    next = end(s.cells);
  }
  CHECK(next == route.centers.size());
  for (std::size_t i = 1; i < route.strips.size(); ++i) {
    // Cells that continue others begin a cell beyond them.
    if (!route.strips[i].continues) continue;
    CHECK_FALSE(sprays_ends(route.strips[i - 1]));
    CHECK(distance(route.strips[i - 1].end, route.strips[i].begin).base() == Approx(4));
  }
  for (const Obstacle& o : field.obstacles) {
    CHECK(nearest_m(route, o.center) >= o.radius.base() + 1.5 - 1e-5);
  }
}

TEST_CASE("the figures of a walk around trees are those of its footprint") {
  CoverageModel model = settings();
  const Field field = orchard({{"tree", at_m(6.3, 48), metres(0.5)}});
  const auto made = cover(field, metres(4), model);
  REQUIRE(made);
  REQUIRE(made->sweep);
  REQUIRE(made->sweep->avoidance);
  const AvoidanceRecord& record = *made->sweep->avoidance;
  CHECK(record.planned.missed + record.planned.repeated <
        record.classic.missed + record.classic.repeated);
  // All but the corners beyond the outermost centres, what the detour misses, and the tree itself.
  const double land_m2 = 6000 - M_PI * 0.25;
  CHECK(made->sweep->areas.covered.base() + made->sweep->areas.missed.base() ==
        Approx(land_m2).epsilon(1e-3));
  CHECK(made->sweep->areas.missed.base() < 60);
  std::get<CoverageSettings>(model).avoidance.reset();
  CHECK_FALSE(cover(field, metres(4), model)->sweep);
}
