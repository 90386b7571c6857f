#include "planner/ferry/hill_ways.hpp"

#include "core/random.hpp"
#include "tests/planner/ferry/behind_hills.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

const Field beyond{.boundary = {at_m(0, 0), at_m(400, 0), at_m(400, 96), at_m(0, 96)},
                   .holes = {},
                   .obstacles = {}};

// A ridge of that height between station and field, down to a fifth 90 m to either side.
FerryMap map(double height_m, const std::optional<RouteSettings>& search,
             std::optional<Length> ceiling = {}) {
  const std::vector<FieldPoint> stands{station};
  const auto level = FerryMap::over(beyond, {.margin = metres(2), .corner_cut = metres(2)}, stands);
  REQUIRE(level);
  const AnalyticTerrain ridge{
      .base = {}, .peaks = {{at_m(200, -50), metres(height_m), metres(70), metres(22)}}};
  const TerrainModel model{
      .ground = ridge, .rule = {.clearance = metres(12), .ceiling = ceiling}, .keep_out = {}};
  return level->over_ground(Relief{model, {at_m(-100, -250), at_m(500, 150)}}, search);
}

constexpr RouteSettings lattice{.evaluations = 1000};

double time_s(const FerryMap& map, const std::vector<FieldPoint>& way) {
  return map.relief()->cost(way.front(), map.relief()->ferry(way, aircraft)).time_s;
}

double ferry_s(const FerryMap& map, FieldPoint from, FieldPoint to) {
  return time_s(map, map.ferry_way(from, to, aircraft));
}

TEST_CASE("Past the ends of a steep ridge ferries are quicker than over it") {
  // Over it: 55 m up at 3 m/s and down at 2 m/s take 46 s, the way of 160 m without it 27 s.
  const FerryMap ways = map(55, lattice);
  const FieldPoint behind = at_m(200, 50);
  const double over_s = time_s(ways, ways.way(station, behind));
  CHECK(over_s > 40);
  CHECK(ferry_s(ways, station, behind) < over_s - 5);
  CHECK(ferry_s(ways, behind, station) < time_s(ways, ways.way(behind, station)) - 5);
}

TEST_CASE("By whatever planner, no ferry takes longer than the shortest way in plan") {
  for (const RoutePlanner planner : route_planners) {
    INFO(name(planner));
    const FerryMap ways = map(55, RouteSettings{.planner = planner, .evaluations = 300});
    double over_s = 0, past_s = 0;
    Random random{1};
    for (int i = 0; i < 20; ++i) {
      const FieldPoint at = at_m(random.uniform(2, 398), random.uniform(2, 94));
      for (const auto& [from, to] : {std::pair{station, at}, std::pair{at, station}}) {
        const double before_s = time_s(ways, ways.way(from, to));
        CHECK(ferry_s(ways, from, to) <= before_s + 1e-9);
        over_s += before_s;
        past_s += ferry_s(ways, from, to);
      }
    }
    CHECK(past_s < 0.95 * over_s);
  }
}

TEST_CASE("Where slopes do not slow an aircraft down its way is the shortest") {
  // 5 m in 22 m: 0.86 * 5 / 22 = 0.20 at its steepest, 2 / 6 is descended at full speed.
  const FerryMap ways = map(5, lattice);
  for (double x = 10; x < 400; x += 30) {
    CHECK(ways.ferry_way(station, at_m(x, 40), aircraft) == ways.way(station, at_m(x, 40)));
  }
}

TEST_CASE(
    "Ways past hills stay on the land of ferries, and between other places are the shortest") {
  const FerryMap ways = map(55, lattice);
  for (double x = 60; x < 400; x += 40) {
    const auto way = ways.ferry_way(station, at_m(x, 30), aircraft);
    for (std::size_t i = 1; i < way.size(); ++i) {
      for (double t = 0; t <= 1; t += 0.05) {
        const FieldVector leg = way[i] - way[i - 1];
        CHECK(ways.is_open(way[i - 1] + FieldVector{t * leg.x, t * leg.y}));
      }
    }
  }
  const FieldPoint aside = at_m(195, -60);
  CHECK(ways.ferry_way(aside, at_m(200, 50), aircraft) == ways.way(aside, at_m(200, 50)));
}

TEST_CASE("Ways are those of any other map, asked in any order, out and home") {
  const FerryMap one = map(55, lattice), other = map(55, lattice);
  std::vector<std::vector<FieldPoint>> out;
  std::vector<FieldPoint> places;
  for (double x = 20; x < 400; x += 35) places.push_back(at_m(x, 20 + x / 10));
  for (const FieldPoint p : places) out.push_back(one.ferry_way(station, p, aircraft));
  for (std::size_t i = places.size(); i-- > 0;) {
    auto home = other.ferry_way(places[i], station, aircraft);
    std::reverse(home.begin(), home.end());
    CHECK(home == out[i]);
  }
}

TEST_CASE("An aircraft that stands a little beside its stand flies past the same places") {
  const FerryMap ways = map(55, lattice);
  const auto way = ways.ferry_way(station, at_m(200, 50), aircraft);
  const auto beside = ways.ferry_way(at_m(200.4, -109.2), at_m(200, 50), aircraft);
  REQUIRE(way.size() > 2);
  CHECK(std::vector(beside.begin() + 1, beside.end()) == std::vector(way.begin() + 1, way.end()));
}

TEST_CASE("Ways lead below a ceiling that the shortest are above") {
  // The crest is at 55 m, ferries keep 12 m: over it they fly at 67 m.
  const FerryMap ways = map(55, lattice, metres(50));
  for (double x = 150; x <= 250; x += 25) {
    const auto way = ways.ferry_way(station, at_m(x, 50), aircraft);
    for (const AirLeg& leg : ways.relief()->ferry(way, aircraft).legs) CHECK(leg.altitude_m <= 50);
  }
}

}  // namespace
}  // namespace furrow::planner
