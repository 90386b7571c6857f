#include "planner/avoidance/field_plan.hpp"

#include "core/random.hpp"
#include "planner/avoidance/crowd.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

using namespace furrow;
using namespace furrow::planner;

namespace {

std::vector<StraightStrip> rows(int count, double length_m, double width_m) {
  std::vector<StraightStrip> strips;
  for (int i = 0; i < count; ++i) {
    const double x = (i + 0.5) * width_m;
    const FieldPoint south = at_m(x, 0), north = at_m(x, length_m);
    strips.push_back({i % 2 == 0 ? south : north, i % 2 == 0 ? north : south, metres(width_m)});
  }
  return strips;
}

Field field_of(double width_m, double length_m) {
  return {{at_m(0, 0), at_m(width_m, 0), at_m(width_m, length_m), at_m(0, length_m)}, {}, {}};
}

Room room_for(const Field& field, Length safety) {
  auto room = room_of(field, metres(0), metres(0), safety);
  REQUIRE(room);
  return *room;
}

Field orchard(std::size_t trees, double width_m, double length_m, std::uint64_t seed) {
  Field field = field_of(width_m, length_m);
  Random random{seed};
  for (std::size_t i = 0; i < trees; ++i) {
    field.obstacles.push_back(
        {std::to_string(i),
         at_m(random.uniform(20, width_m - 20), random.uniform(20, length_m - 20)),
         metres(random.uniform(0.5, 2))});
  }
  return field;
}

double nearest_m(const AvoidancePlan& plan, FieldPoint p) {
  double least = INFINITY;
  for (const AvoidedStrip& strip : plan.strips) {
    for (const Stretch& stretch : strip.stretches) {
      PathM path;
      for (const FieldPoint at : stretch.line) path.push_back({at.x.base(), at.y.base()});
      least = std::min(least, distance_m({p.x.base(), p.y.base()}, path));
    }
  }
  return least;
}

AvoidanceSettings settings_of(AvoidanceMethod method) {
  AvoidanceSettings s;
  s.method = method;
  s.turn_radius = metres(3);
  return s;
}

}  // namespace

TEST_CASE("half circles clear trees beside the line that one over a target would enter") {
  Field field = field_of(30, 100);
  // On the line x = 9 that is flown southwards, and 5 m beside it on its left.
  field.obstacles = {{"on", at_m(9, 50), metres(2)}, {"beside", at_m(14, 52), metres(1)}};
  const AvoidancePlan plan = plan_avoidance(rows(2, 100, 6), room_for(field, metres(1.5)),
                                            settings_of(AvoidanceMethod::classic));
  CHECK(nearest_m(plan, at_m(9, 50)) > 2 + 1.5 - 0.02);
  CHECK(nearest_m(plan, at_m(14, 52)) > 1 + 1.5 - 0.02);
}

TEST_CASE("strips without obstacles stay as they are") {
  const Field field = field_of(30, 100);
  const AvoidancePlan plan = plan_avoidance(rows(5, 100, 6), room_for(field, metres(2)),
                                            settings_of(AvoidanceMethod::genetic));
  REQUIRE(plan.strips.size() == 5);
  for (const AvoidedStrip& strip : plan.strips) {
    REQUIRE(strip.stretches.size() == 1);
    CHECK(strip.stretches[0].line.size() == 2);
  }
  CHECK(plan.figures.targets == 0);
  CHECK(plan.figures.extra == metres(0));
  CHECK((plan.figures.missed + plan.figures.repeated).base() == Approx(0).margin(1e-3));
}

TEST_CASE("a tree on one strip is flown around on its nearer side") {
  Field field = field_of(30, 100);
  field.obstacles.push_back({"tree", at_m(15.5, 50), metres(1)});  // strip 3 runs north at x = 15
  const AvoidancePlan plan = plan_avoidance(rows(5, 100, 6), room_for(field, metres(2)),
                                            settings_of(AvoidanceMethod::exact));
  CHECK(plan.figures.targets == 1);
  CHECK(plan.figures.detours == 1);
  REQUIRE(plan.strips[2].stretches.size() == 1);
  double west_m = INFINITY;
  for (const FieldPoint p : plan.strips[2].stretches[0].line) {
    west_m = std::min(west_m, p.x.base());
  }
  // The circle of 3 m reaches 2.5 m to the left of the line and 3.5 m to the right.
  CHECK(west_m == Approx(15.5 - 3).margin(0.06));
  CHECK(nearest_m(plan, at_m(15.5, 50)) >= 3 - 1e-6);
}

TEST_CASE("a tree at the end of a strip ends the strip before it") {
  Field field = field_of(30, 100);
  field.obstacles.push_back({"tree", at_m(15, 97), metres(1)});
  const AvoidancePlan plan = plan_avoidance(rows(5, 100, 6), room_for(field, metres(2)),
                                            settings_of(AvoidanceMethod::genetic));
  CHECK(plan.figures.blocked == 1);
  REQUIRE(plan.strips[2].stretches.size() == 1);
  // R = R_z = 3: the last turn away begins sqrt(36 - 9) before the tree.
  CHECK(plan.strips[2].stretches[0].line.back().y.base() == Approx(97 - std::sqrt(27.0)));
}

TEST_CASE("a strip along the edge of the field is passed on the side of the field") {
  Field field = field_of(30, 100);
  field.obstacles.push_back({"tree", at_m(2.5, 50), metres(1)});  // left: 1.6 m outside the field
  const AvoidancePlan plan = plan_avoidance(rows(5, 100, 6), room_for(field, metres(2)),
                                            settings_of(AvoidanceMethod::exact));
  CHECK(plan.figures.detours + plan.figures.closed == 1);
  for (const Stretch& s : plan.strips[0].stretches) {
    for (const FieldPoint p : s.line) CHECK(p.x >= metres(0));
  }
}

TEST_CASE("crowded trees are passed together on one side") {
  Field field = field_of(30, 100);
  field.obstacles.push_back({"a", at_m(15, 50), metres(1)});
  field.obstacles.push_back({"b", at_m(15.5, 55), metres(1)});
  field.obstacles.push_back({"c", at_m(14.8, 60), metres(1)});
  const AvoidancePlan plan = plan_avoidance(rows(5, 100, 6), room_for(field, metres(2)),
                                            settings_of(AvoidanceMethod::exact));
  CHECK(plan.figures.targets == 3);
  CHECK(plan.figures.crowds == 1);
  for (const Obstacle& o : field.obstacles) CHECK(nearest_m(plan, o.center) >= 3 - 1e-6);
}

TEST_CASE("splitting closes the valve on the way around") {
  Field field = field_of(30, 100);
  field.obstacles.push_back({"tree", at_m(15.5, 50), metres(1)});
  const AvoidancePlan plan = plan_avoidance(rows(5, 100, 6), room_for(field, metres(2)),
                                            settings_of(AvoidanceMethod::split));
  REQUIRE(plan.strips[2].stretches.size() == 3);
  CHECK(plan.strips[2].stretches[0].spraying);
  CHECK_FALSE(plan.strips[2].stretches[1].spraying);
  CHECK(plan.strips[2].stretches[2].spraying);
  CHECK(plan.strips[2].stretches[1].line.back() == plan.strips[2].stretches[2].line.front());
}

TEST_CASE("genetic search of a field comes close to its exact selection") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Field field = orchard(40, 240, 300, seed);
    const Room room = room_for(field, metres(1.5));
    const auto strips = rows(40, 300, 6);
    const auto exact = plan_avoidance(strips, room, settings_of(AvoidanceMethod::exact));
    const auto genetic = plan_avoidance(strips, room, settings_of(AvoidanceMethod::genetic));
    REQUIRE(exact.figures.exact);
    CHECK(genetic.figures.fitness >= exact.figures.fitness - 1e-12);
    CHECK(genetic.figures.fitness <= 1.001 * exact.figures.fitness);
  }
}

TEST_CASE("detours leave far less ground missed or repeated than half circles") {
  const Field field = orchard(30, 240, 300, 9);
  const Room room = room_for(field, metres(1.5));
  const auto ours = plan_avoidance(rows(40, 300, 6), room, settings_of(AvoidanceMethod::genetic));
  const auto half = plan_avoidance(rows(40, 300, 6), room, settings_of(AvoidanceMethod::classic));
  const double ratio =
      (half.figures.missed + half.figures.repeated) / (ours.figures.missed + ours.figures.repeated);
  std::cout << "orchard: classic " << half.figures.missed.base() << " + "
            << half.figures.repeated.base() << " m2, +" << half.figures.extra.base()
            << " m; planned " << ours.figures.missed.base() << " + " << ours.figures.repeated.base()
            << " m2, +" << ours.figures.extra.base() << " m of " << ours.figures.straight.base()
            << " m; ratio " << ratio << "; detours " << ours.figures.detours << " closed "
            << ours.figures.closed << " blocked " << ours.figures.blocked << '\n';
  CHECK(ratio >= 3);
}

namespace {

struct SceneCount {
  std::size_t blocked = 0, detours = 0, closed = 0, too_near = 0;
};

// Scenes of up to 25 trees on ten strips, each planned and measured.
SceneCount random_scenes(std::uint64_t scenes) {
  SceneCount count;
  for (std::uint64_t seed = 0; seed < scenes; ++seed) {
    const Field field = orchard(1 + seed % 25, 60, 120, seed);
    auto s = settings_of(seed % 2 == 0 ? AvoidanceMethod::genetic : AvoidanceMethod::split);
    s.iterations = 20;
    const AvoidancePlan plan = plan_avoidance(rows(10, 120, 6), room_for(field, metres(1.5)), s);
    for (const Obstacle& o : field.obstacles) {
      if (nearest_m(plan, o.center) < o.radius.base() + 1.5 - 1e-5) ++count.too_near;
    }
    count.blocked += plan.figures.blocked;
    count.detours += plan.figures.detours;
    count.closed += plan.figures.closed;
  }
  return count;
}

}  // namespace

TEST_CASE("random scenes keep every leg clear or say where a strip is blocked") {
  const SceneCount count = random_scenes(50);
  CHECK(count.too_near == 0);
  CHECK(count.detours > 0);
  CHECK(count.blocked > 0);
}

TEST_CASE("ten thousand random scenes keep every leg clear", "[.][sweep]") {
  const SceneCount count = random_scenes(10'000);
  std::cout << "10000 scenes: " << count.detours << " detours, " << count.closed << " closed, "
            << count.blocked << " blocked, " << count.too_near << " too near\n";
  CHECK(count.too_near == 0);
}

TEST_CASE("poles in a row are passed with far less wrong area than by half circles") {
  // 14 poles of 0.5 m, 20 m apart along a line across the field at 20 degrees to the strips.
  Field field = field_of(240, 300);
  for (int i = 0; i < 14; ++i) {
    field.obstacles.push_back({std::to_string(i), at_m(70 + i * 6.84, 20 + i * 18.8), metres(0.5)});
  }
  const Room room = room_for(field, metres(2));
  const auto ours = plan_avoidance(rows(40, 300, 6), room, settings_of(AvoidanceMethod::genetic));
  const auto half = plan_avoidance(rows(40, 300, 6), room, settings_of(AvoidanceMethod::classic));
  const double ratio =
      (half.figures.missed + half.figures.repeated) / (ours.figures.missed + ours.figures.repeated);
  std::cout << "poles: classic " << half.figures.missed.base() << " + "
            << half.figures.repeated.base() << " m2, +" << half.figures.extra.base()
            << " m; planned " << ours.figures.missed.base() << " + " << ours.figures.repeated.base()
            << " m2, +" << ours.figures.extra.base() << " m; ratio " << ratio << '\n';
  CHECK(ratio >= 2);
}

TEST_CASE("a pond on a strip is flown around along its hull, clear of its edges") {
  const PassM pass{{0, 0}, {120, 0}, 6};
  const RingM pond{{50, -2}, {60, -3}, {64, 2}, {55, 4}};
  const Room room{{}, {{pond, 2}}, {}};
  const auto targets = targets_of(pass, room);
  REQUIRE(targets.size() == 1);
  const auto crowds = crowds_of(pass, targets, room, 3);
  REQUIRE(crowds.size() == 1);
  REQUIRE(crowds[0].options.size() == 3);  // left, right, closed
  for (const CrowdOption& option : crowds[0].options) {
    CHECK(room.is_clear(tangent_path(option.curve, corner_rad)));
    CHECK(option.extra_m > 0);
  }
}
