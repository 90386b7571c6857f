#include "agents/conduct/surroundings.hpp"

#include "agents/conduct/sortie_route.hpp"
#include "agents/guidance/pilot.hpp"
#include "tests/agents/scripted_fleet.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace furrow::agents {
namespace {

// Room to x = -half .. half beside a line to the north, 2 m clear of what is seen.
Surroundings alley(double half_m, const std::vector<SeenObstacle>& seen = {}) {
  const planner::LandParts land{
      {{{-half_m, -20}, {half_m, -20}, {half_m, 120}, {-half_m, 120}}, {}}};
  Surroundings around{
      {.planned = {{}, {}, land}, .clearance = metres(2), .turn_radius = metres(3)}};
  for (const SeenObstacle& o : seen) around.learn(o);
  return around;
}

SeenObstacle tree(double x_m, double y_m) { return {at_m(x_m, y_m), metres(1)}; }

// One strip of 49 cells of 2 m from end to end, to the north.
Piece strip() { return {{0, 49}, at_m(0, 0), at_m(0, 1), at_m(0, 97), at_m(0, 98)}; }

SortieRoute route_of(const Piece& piece, const Surroundings& around) {
  return sortie_route({0, 0}, {{piece}}, {0, 0}, sprayer(), {}, around);
}

double least_distance_m(const SortieRoute& route, double to_m, FieldPoint place) {
  double least = no_stop;
  for (const Segment& s : route.path.segments()) {
    for (double m = s.start_m; m <= std::min(s.end_m(), to_m); m += 0.05) {
      least = std::min(least, norm(pose(s, m).at - xy_m(place)));
    }
  }
  return least;
}

}  // namespace

TEST_CASE("an obstacle is learnt once") {
  Surroundings around = alley(20);
  CHECK(around.learn(tree(0, 50)));
  CHECK_FALSE(around.learn(tree(0, 50)));
  CHECK(around.seen().size() == 1);
}

TEST_CASE("a straight way is clear up to where it enters the clearance of an obstacle") {
  const Surroundings around = alley(20, {tree(0, 50)});
  // 1 m of tree and 2 m of clearance.
  CHECK(around.clear_m(at_m(0, 0), at_m(0, 98)).value() == Approx(47));
  CHECK_FALSE(around.clear_m(at_m(0, 0), at_m(0, 46)));
  CHECK_FALSE(around.clear_m(at_m(0, 54), at_m(0, 98)));
  CHECK_FALSE(around.clear_m(at_m(3.1, 0), at_m(3.1, 98)));
  CHECK(around.is_too_near(at_m(0, 52.9)));
  CHECK_FALSE(around.is_too_near(at_m(0, 53.1)));
}

TEST_CASE("a strip is flown around a tree that was seen and keeps the clearance") {
  const Surroundings around = alley(20, {tree(0.3, 50)});
  const SortieRoute route = route_of(strip(), around);
  CHECK_FALSE(route.blocked_m);
  REQUIRE(route.pieces.front().is_bent());
  // Rounded corners of 0.35 rad stay outside the circle of 3 m that their tangents touch.
  CHECK(least_distance_m(route, no_stop, at_m(0.3, 50)) > 3 - 1e-3);
  const PieceOnPath& bent = route.pieces.front();
  // The detour begins and ends within R_z + R = 6 m of the tree, along the line.
  CHECK(bent.bends_from_m > 43.0);
  CHECK(bent.bends_to_m < 98.0);
}

TEST_CASE("cells of a bent strip count abeam, in order, and as always where it is straight") {
  const SortieRoute plain = route_of(strip(), alley(20));
  const SortieRoute route = route_of(strip(), alley(20, {tree(0.3, 50)}));
  for (std::uint32_t i = 0; i < 49; ++i) {
    const double at_m = route.cell_m(0, i);
    if (i > 0) CHECK(at_m > route.cell_m(0, i - 1));
    if (i < 21) CHECK(at_m == Approx(plain.cell_m(0, i)).margin(1e-9));
  }
  const auto length_m = [](const PieceOnPath& p) { return p.close_m - p.open_m; };
  const double extra_m = length_m(route.pieces.front()) - length_m(plain.pieces.front());
  CHECK(extra_m > 0.5);
  CHECK(route.cell_m(0, 48) == Approx(plain.cell_m(0, 48) + extra_m).margin(1e-6));
}

// 2.9 m to either edge, and a detour takes 3 m.
TEST_CASE("a wide tree is flown around with the valve closed and its cells count abeam") {
  const SortieRoute route = route_of(strip(), alley(40, {{at_m(0.3, 50), metres(12)}}));
  CHECK_FALSE(route.blocked_m);
  const PieceOnPath& piece = route.pieces.front();
  REQUIRE(piece.closed.size() == 1);
  const auto [from_m, to_m] = piece.closed.front();
  CHECK(from_m >= piece.open_m);
  CHECK(to_m - from_m > 2 * 12);  // around it
  CHECK(route.spray_m == Approx(piece.close_m - piece.open_m - (to_m - from_m)));
  CHECK(piece.is_sprayed(from_m - 0.1));
  CHECK_FALSE(piece.is_sprayed(0.5 * (from_m + to_m)));
  CHECK(piece.is_sprayed(to_m + 0.1));
  CHECK(piece.sprayed_m(from_m - 1, from_m + 1) == Approx(1));
  CHECK(piece.valve_moves_m(from_m - 1, from_m + 1) == from_m);
  CHECK(piece.valve_moves_m(to_m - 1, to_m + 1) == to_m);
  for (std::uint32_t i = 1; i < 49; ++i) CHECK(route.cell_m(0, i) >= route.cell_m(0, i - 1));
}

TEST_CASE("a strip that begins or ends in a tree is flown as far as it is clear, no cell lost") {
  // Clear from y = 1 + 3 m on, and a hand's breadth.
  const SortieRoute begins =
      sortie_route({-20, 0}, {{strip()}}, {0, 98}, sprayer(), {}, alley(40, {tree(0, 1)}));
  CHECK_FALSE(begins.blocked_m);
  const PieceOnPath& piece = begins.pieces.front();
  CHECK(piece.close_m - piece.open_m == Approx(98 - 4.05).margin(0.01));
  CHECK(begins.cell_m(0, 0) == Approx(piece.open_m));
  // The centre of cell i lies at 1 + 2 i.
  CHECK(begins.cell_m(0, 10) == Approx(piece.open_m + 21 - 4.05).margin(0.01));
  CHECK(least_distance_m(begins, no_stop, at_m(0, 1)) > 3 - 1e-3);

  const SortieRoute ends = route_of(strip(), alley(40, {tree(0, 97.5)}));
  CHECK_FALSE(ends.blocked_m);
  CHECK(ends.cell_m(0, 48) == Approx(ends.pieces.front().close_m));
  CHECK(least_distance_m(ends, ends.pieces.front().close_m, at_m(0, 97.5)) > 3 - 1e-3);

  // A tree 3 m wide with its clearance, 0.5 m behind the beginning: no turn fits before it.
  const SortieRoute near_begin =
      sortie_route({-20, 0}, {{strip()}}, {0, 98}, sprayer(), {}, alley(40, {tree(0, 3.5)}));
  CHECK_FALSE(near_begin.blocked_m);
  const PieceOnPath& behind = near_begin.pieces.front();
  CHECK(behind.close_m - behind.open_m == Approx(98 - 6.55).margin(0.01));

  // Nothing of a strip is clear: blocked as before.
  CHECK(route_of(strip(), alley(200, {{at_m(1, 50), metres(60)}})).blocked_m);
}

TEST_CASE("a strip of cells with a tree at the step that leads to it stays on its own line") {
  // From the strip at x = 0 over to the one at x = 4 and down that.
  const Piece piece{{0, 49}, at_m(0, 96), at_m(4, 96), at_m(4, 0), at_m(4, 0)};
  for (const SeenObstacle& seen : {tree(0, 97), tree(4, 97), tree(2, 98.5)}) {
    const SortieRoute route = route_of(piece, alley(40, {seen}));
    CHECK_FALSE(route.blocked_m);
    CHECK(least_distance_m(route, no_stop, at_m(4, 50)) < 0.03);
    CHECK(least_distance_m(route, no_stop, at_m(4, 90)) < 0.03);
    CHECK(least_distance_m(route, no_stop, seen.center) > 3 - 1e-3);
  }
}

TEST_CASE("a strip without room for a detour is blocked before the clearance") {
  const SortieRoute route = route_of(strip(), alley(2.9, {tree(0, 50)}));
  REQUIRE(route.blocked_m);
  CHECK(*route.blocked_m == Approx(46.5));  // half a metre before 50 - 3
}

TEST_CASE("a strip of no length is blocked where an obstacle stands on it") {
  const Surroundings around = alley(20, {tree(0, 50)});
  CHECK_FALSE(around.strip_bends(at_m(0, 50), at_m(0, 50), metres(2)));
  CHECK(around.strip_bends(at_m(0, 40), at_m(0, 40), metres(2))->empty());
}

TEST_CASE("a ferry among trees that leave no room for curves goes by corners between them") {
  // It ends 0.1 m beside the clearance of the last tree.
  const Surroundings around = alley(20, {tree(0, 50), tree(6.3, 50), tree(0.5, 94.8)});
  const auto way = around.ferry_bends(at_m(0, 0), at_m(0, 98));
  REQUIRE(way);
  CHECK_FALSE(way->leaves_land);
  planner::PathM path{{0, 0}};
  for (const FieldPoint bend : way->bends) path.push_back({bend.x.base(), bend.y.base()});
  path.push_back({0, 98});
  for (const SeenObstacle& o : around.seen()) {
    CHECK(planner::distance_m({o.center.x.base(), o.center.y.base()}, path) >= 3 - 1e-6);
  }
}

TEST_CASE("a ferry leaves the land where there is no way around inside") {
  const Surroundings around = alley(2.9, {tree(0, 50)});
  CHECK_FALSE(around.strip_bends(at_m(0, 0), at_m(0, 98), metres(2)));
  const auto way = around.ferry_bends(at_m(0, 0), at_m(0, 98));
  REQUIRE(way);
  CHECK(way->leaves_land);
  for (const FieldPoint bend : way->bends) CHECK_FALSE(around.is_too_near(bend));
}

TEST_CASE(
    "a ferry that begins too near to an obstacle leaves it first, one that ends so has no way") {
  const Surroundings around = alley(20, {tree(0, 50)});
  const auto out = around.ferry_bends(at_m(0, 48), at_m(0, 98));
  REQUIRE(out);
  CHECK(distance(out->bends.front(), at_m(0, 47)).base() == Approx(0.05));
  CHECK_FALSE(around.ferry_bends(at_m(0, 0), at_m(0, 51)));
}

// Ground that rises by a tenth to the north, as a raster of 10 m.
planner::FerryMap slope() {
  Raster ground{
      .south_west = at_m(-50, -50), .step = metres(10), .columns = 11, .rows = 21, .heights_m = {}};
  for (int row = 0; row < 21; ++row) {
    ground.heights_m.insert(ground.heights_m.end(), 11, static_cast<float>(row - 5));
  }
  return planner::FerryMap{}.over_ground({planner::Surface{std::move(ground)}, {}, {}});
}

TEST_CASE("over a slope a strip is flown around a tree at the height of work above the ground") {
  const Surroundings around = alley(20, {tree(0.3, 50)});
  const SortieRoute level = route_of(strip(), around);
  const SortieRoute route = sortie_route({0, 0}, {{strip()}}, {0, 0}, sprayer(), slope(), around);
  CHECK_FALSE(route.blocked_m);
  const PieceOnPath& bent = route.pieces.front();
  REQUIRE(bent.is_bent());
  CHECK(bent.bends_from_m == Approx(level.pieces.front().bends_from_m).margin(0.1));
  CHECK(least_distance_m(route, bent.close_m, at_m(0.3, 50)) > 3 - 1e-3);
  for (std::uint32_t i = 0; i < 49; ++i) {
    // Cell i lies at y = 1 + 2 i, and the ground there at y / 10; a rounded corner shifts it a
    // little.
    CHECK(route.heights.altitude_m(route.cell_m(0, i)) ==
          Approx(0.1 * (1 + 2 * i) + 3).margin(0.05));
  }
}

TEST_CASE("over a slope a ferry is led around a tree at the clearance of ferries") {
  const SortieRoute route =
      sortie_route({0, 0}, {}, {0, 98}, sprayer(), slope(), alley(20, {tree(0, 50)}));
  CHECK_FALSE(route.blocked_m);
  CHECK(least_distance_m(route, no_stop, at_m(0, 50)) > 3 - 0.05);
  CHECK(route.heights.altitude_m(0.5 * route.path.length_m()) >= 0.1 * 49 + 15 - 0.05);
}

TEST_CASE("over a slope a ferry laid in the air begins at the height of the aircraft") {
  const auto first_m = [](std::optional<Length> begins) {
    return sortie_route({0, 0}, {}, {0, 98}, sprayer(), slope(), alley(20), begins)
        .heights.altitude_m(0.0);
  };
  CHECK(first_m(metres(20)) == Approx(20));
  // The ground is at 0 m there and work 3 m above it: from the ground, or from too low.
  CHECK(first_m({}) == Approx(3));
  CHECK(first_m(metres(1)) == Approx(3));
}

TEST_CASE("no corner is cut that an obstacle is near to") {
  // From (0, 0) by (0, 50), past a tree inside the corner, to (40, 50): 4.1 m from both legs.
  Piece corner = strip();
  corner.cells = {0, 1};
  corner.entry = corner.from = corner.to = corner.exit = at_m(0, 50);
  Vehicle wide = sprayer();
  wide.swath = metres(20);
  const SeenObstacle inside = tree(3.2, 46.8);
  const Surroundings near = alley(60, {inside});
  const SortieRoute cut = sortie_route({0, 0}, {{corner}}, {40, 50}, wide, {}, alley(60));
  const SortieRoute held = sortie_route({0, 0}, {{corner}}, {40, 50}, wide, {}, near);
  CHECK(least_distance_m(cut, no_stop, inside.center) < 3);
  CHECK(least_distance_m(held, no_stop, inside.center) > 3 - 1e-3);
}

TEST_CASE(
    "a pilot goes on along a route that bends ahead of it, and not along one that bent behind") {
  const SortieRoute plain = route_of(strip(), alley(20));
  const SortieRoute bent = route_of(strip(), alley(20, {tree(0.3, 50)}));
  Pilot pilot{2.7, 3.0};
  pilot.follow(plain.path);
  CHECK(pilot.leads_on(bent.path));
  const auto fly_to = [&](double along_m) {
    while (pilot.pace().along_m() < along_m) {
      const Pose at = pose(pilot.segment(), pilot.pace().along_m());
      pilot.steer(no_stop, at.at, pilot.pace().speed_mps() * at.ahead);
    }
  };
  fly_to(30);
  REQUIRE(pilot.leads_on(bent.path));
  const double speed_mps = pilot.pace().speed_mps();
  pilot.redirect(bent.path);
  CHECK(pilot.pace().speed_mps() == speed_mps);
  CHECK(pilot.leads_on(plain.path));
  fly_to(48);
  CHECK_FALSE(pilot.leads_on(plain.path));
}

TEST_CASE("a pilot too fast for a bend does not take it") {
  // Arcs of 3 m are flown at sqrt(0.9 2.7 3) = 2.7 m/s; from 10 m/s that takes
  // (100 - 7) / (2 2.7) = 17 m.
  Vehicle fast = sprayer();
  fast.spray_speed = metres_per_second(10);
  const auto laid = [&](const Surroundings& around) {
    return sortie_route({0, 0}, {{strip()}}, {0, 0}, fast, {}, around);
  };
  Pilot pilot{2.7, 3.0};
  pilot.follow(laid(alley(20)).path);
  const auto fly_to = [&](double along_m) {
    while (pilot.pace().along_m() < along_m) {
      const Pose at = pose(pilot.segment(), pilot.pace().along_m());
      pilot.steer(no_stop, at.at, pilot.pace().speed_mps() * at.ahead);
    }
  };
  fly_to(24);
  const SortieRoute bent = laid(alley(20, {tree(0.3, 50)}));
  CHECK(pilot.leads_on(bent.path));
  fly_to(36);
  CHECK_FALSE(pilot.leads_on(bent.path));
}

}  // namespace furrow::agents
