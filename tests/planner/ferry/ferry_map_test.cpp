#include "planner/ferry/ferry_map.hpp"

#include "core/random.hpp"
#include "planner/coverage/geos.hpp"
#include "planner/coverage/swath/swath.hpp"
#include "planner/ferry/bends.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow;
using namespace furrow::planner;

namespace {

const Ring u_shape{at_m(0, 0),    at_m(150, 0), at_m(150, 130), at_m(100, 130),
                   at_m(100, 40), at_m(50, 40), at_m(50, 130),  at_m(0, 130)};

double length_of(const std::vector<FieldPoint>& way) {
  double sum_m = 0;
  for (std::size_t i = 1; i < way.size(); ++i) sum_m += distance(way[i - 1], way[i]).base();
  return sum_m;
}

LandPart part_of(const Ring& ring) {
  LandPart part;
  for (const FieldPoint p : ring) part.outer.push_back({p.x.base(), p.y.base()});
  return part;
}

PathM path_of(const std::vector<FieldPoint>& way) {
  PathM path;
  for (const FieldPoint p : way) path.push_back({p.x.base(), p.y.base()});
  return path;
}

}  // namespace

TEST_CASE("without land every ferry way is straight") {
  const FerryMap open;
  CHECK(open.way(at_m(0, 0), at_m(3, 4)) == std::vector{at_m(0, 0), at_m(3, 4)});
  CHECK(open.length(at_m(0, 0), at_m(3, 4)).base() == Approx(5));
}

TEST_CASE("a ferry way goes round the bay of a field, not over it") {
  const std::vector<FieldPoint> stands{at_m(0, 130)};
  const auto map = FerryMap::over({.boundary = u_shape, .holes = {}, .obstacles = {}}, {}, stands);
  REQUIRE(map);
  // From the tip of one arm to the tip of the other: down to (50, 40), across, and up again:
  // 2 sqrt(50^2 + 90^2) + 50.
  const double round_m = 2 * std::hypot(50, 90) + 50;
  CHECK(map->length(at_m(0, 130), at_m(150, 130)).base() == Approx(round_m).margin(1e-4));
  CHECK(length_of(map->way(at_m(0, 130), at_m(150, 130))) == Approx(round_m).margin(1e-4));
}

TEST_CASE("a ferry way keeps the safety distance from a tree and from an outline") {
  const Field field{
      .boundary = {at_m(0, 0), at_m(100, 0), at_m(100, 100), at_m(0, 100)},
      .holes = {},
      .obstacles = {{"tree", at_m(30, 51), metres(3), {}},
                    outlined("barn", {at_m(60, 45), at_m(80, 45), at_m(80, 60), at_m(60, 60)})}};
  const std::vector<FieldPoint> stands{at_m(0, 50)};
  const auto map = FerryMap::over(field, {.safety = metres(1.5), .corner_cut = metres(3)}, stands);
  REQUIRE(map);
  for (const FieldPoint to : {at_m(100, 50), at_m(82, 50), at_m(45, 50)}) {
    for (const auto& way : {map->way(stands[0], to), map->way(to, at_m(5, 90))}) {
      for (std::size_t i = 1; i < way.size(); ++i) {
        for (int k = 0; k <= 100; ++k) {
          const FieldVector leg = way[i] - way[i - 1];
          const FieldPoint at = way[i - 1] + FieldVector{0.01 * k * leg.x, 0.01 * k * leg.y};
          for (const Obstacle& o : field.obstacles) CHECK(-depth_in(o, at).base() > 1.5 - 1e-5);
        }
      }
    }
  }
  const std::vector<FieldPoint> near{at_m(81, 50)};  // a metre from the barn
  CHECK(FerryMap::over(field, {.safety = metres(1.5)}, near).error().fault ==
        PlanFault::out_of_reach);
}

TEST_CASE("a ferry way keeps the buffer from a hole and from an obstacle") {
  const Field field{.boundary = {at_m(0, 0), at_m(100, 0), at_m(100, 100), at_m(0, 100)},
                    .holes = {{at_m(40, 40), at_m(60, 40), at_m(60, 60), at_m(40, 60)}},
                    .obstacles = {{"tree", at_m(50, 20), metres(3)}}};
  const std::vector<FieldPoint> stands{at_m(0, 50)};
  const auto map = FerryMap::over(field, {.hole_buffer = metres(2)}, stands);
  REQUIRE(map);
  const LandParts hole{
      part_of({at_m(38.01, 38.01), at_m(61.99, 38.01), at_m(61.99, 61.99), at_m(38.01, 61.99)})};
  const PathM across = path_of(map->way(at_m(0, 50), at_m(100, 50)));
  CHECK(length_outside_m({across}, hole) == Approx(length_m(across)).margin(1e-6));
  const auto past_tree = map->way(at_m(50, 10), at_m(50, 30));
  for (std::size_t i = 1; i < past_tree.size(); ++i) {
    for (double t = 0; t <= 1; t += 0.01) {
      const FieldVector leg = past_tree[i] - past_tree[i - 1];
      const FieldPoint at = past_tree[i - 1] + FieldVector{t * leg.x, t * leg.y};
      CHECK(distance(at, at_m(50, 20)).base() >= 5 - 1e-5);
    }
  }
}

TEST_CASE("a station outside has an apron and reaches the field by it") {
  const std::vector<FieldPoint> stands{at_m(75, -10)};
  const auto map = FerryMap::over({.boundary = u_shape, .holes = {}, .obstacles = {}}, {}, stands);
  REQUIRE(map);
  // Straight where the apron, 15.05 m around the station, meets the field on the way.
  CHECK(map->length(at_m(75, -10), at_m(80, 30)).base() == Approx(std::hypot(5, 40)));
  CHECK(map->length(at_m(75, -10), at_m(150, 1)).base() > std::hypot(75, 11) + 0.1);
}

TEST_CASE("parts that a margin splits are joined through the neck between them") {
  // Two squares and a neck of 4 m between them, gone under a margin of 3 m.
  const Field field{.boundary = {at_m(0, 0), at_m(50, 0), at_m(50, 23), at_m(70, 23), at_m(70, 0),
                                 at_m(120, 0), at_m(120, 50), at_m(70, 50), at_m(70, 27),
                                 at_m(50, 27), at_m(50, 50), at_m(0, 50)},
                    .holes = {},
                    .obstacles = {}};
  const std::vector<FieldPoint> stands{at_m(25, 25)};
  const auto map = FerryMap::over(field, {.margin = metres(3)}, stands);
  REQUIRE(map);
  CHECK(map->length(at_m(25, 25), at_m(95, 25)).base() == Approx(70));
  const auto outside = length_outside(field, {map->way(at_m(25, 5), at_m(95, 5))}, metres(1e-3));
  REQUIRE(outside);
  CHECK(*outside == Length{});
}

TEST_CASE("parts that a margin splits and no neck joins are joined where they are nearest") {
  // A neck of 4 m, and all across it a wall of which flight keeps clear by 3 m.
  const Field field{.boundary = {at_m(0, 0), at_m(50, 0), at_m(50, 23), at_m(70, 23), at_m(70, 0),
                                 at_m(120, 0), at_m(120, 50), at_m(70, 50), at_m(70, 27),
                                 at_m(50, 27), at_m(50, 50), at_m(0, 50)},
                    .holes = {{at_m(59, 22), at_m(61, 22), at_m(61, 28), at_m(59, 28)}},
                    .obstacles = {}};
  const std::vector<FieldPoint> stands{at_m(25, 25)};
  const auto map = FerryMap::over(field, {.margin = metres(3)}, stands);
  REQUIRE(map);
  // Past the end of the wall, 3 m beyond 22 or 28, and straight over foreign land.
  CHECK(map->length(at_m(25, 25), at_m(95, 25)).base() >= 2 * std::hypot(35, 6) - 1);
  CHECK(map->length(at_m(25, 25), at_m(95, 25)).base() <= 70 + 2 * 22);
}

TEST_CASE("a station in an obstacle is refused by name of its place") {
  const Field field{.boundary = {at_m(0, 0), at_m(100, 0), at_m(100, 100), at_m(0, 100)},
                    .holes = {},
                    .obstacles = {{"tree", at_m(50, 20), metres(3)}}};
  const std::vector<FieldPoint> stands{at_m(51, 20)};
  const auto map = FerryMap::over(field, {}, stands);
  REQUIRE(!map);
  CHECK(map.error().fault == PlanFault::out_of_reach);
  CHECK(map.error().detail ==
        "(51.000, 20.000) m lies in a hole or an obstacle, or too near to one");
}

TEST_CASE("lengths from a stand are those of the ways") {
  const Field field{.boundary = u_shape,
                    .holes = {{at_m(10, 10), at_m(30, 10), at_m(20, 30)}},
                    .obstacles = {{"mast", at_m(120, 20), metres(4)}}};
  const std::vector<FieldPoint> stands{at_m(5, 125)};
  const auto map = FerryMap::over(field, {}, stands);
  REQUIRE(map);
  const LandPart land = part_of(u_shape);
  const EdgeGrid edges{land};
  Random random{7};
  for (int n = 0; n < 500;) {
    const PointM p{random.uniform(0, 150), random.uniform(0, 130)};
    if (!edges.contains(p)) continue;
    ++n;
    const FieldPoint to = at_m(p.x, p.y);
    CHECK(map->length(stands[0], to).base() ==
          Approx(length_of(map->way(stands[0], to))).margin(1e-6));
  }
}

TEST_CASE("a moved bend keeps its rounding clear of the corner") {
  // A right-angled bend around the corner (50, 40) of the bay; arcs that cut 2 m pass it inside by
  // 2 tan(45 / 2 deg) = 0.83 m where nothing is moved.
  const EdgeGrid edges{part_of(u_shape)};
  const PathM moved = clear_of_corners({{50, 90}, {50, 40}, {90, 40}}, edges, 2);
  REQUIRE(moved.size() == 3);
  const PointM in = moved[1] - moved[0], out = moved[2] - moved[1];
  const double turn = std::abs(std::atan2(cross(in, out), dot(in, out)));
  CHECK(norm(moved[1] - PointM{50, 40}) >= 2 * std::tan(turn / 4));
  CHECK(edges.sees(moved[0], moved[1]));
  CHECK(edges.sees(moved[1], moved[2]));
}

TEST_CASE("land that a closed zone cuts off is out of reach") {
  // A zone of 20 m across a field of 200 x 100 m, the stand on its western side.
  const Field field{.boundary = {at_m(0, 0), at_m(200, 0), at_m(200, 100), at_m(0, 100)},
                    .holes = {},
                    .obstacles = {outlined(
                        "road", {at_m(90, -10), at_m(110, -10), at_m(110, 110), at_m(90, 110)})}};
  const std::vector<FieldPoint> stands{at_m(20, -5)};
  const auto map = FerryMap::over(field, {}, stands);
  REQUIRE(map);
  CHECK(map->reaches(at_m(50, 50)));
  CHECK_FALSE(map->reaches(at_m(150, 50)));
}
