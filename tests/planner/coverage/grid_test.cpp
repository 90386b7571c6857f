#include "planner/coverage/grid.hpp"

#include "core/random.hpp"
#include "tests/planner/paper_case.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace furrow::planner {
namespace {

using Catch::Matchers::Contains;

int workable(const Grid& grid) {
  return std::accumulate(grid.workable.begin(), grid.workable.end(), 0);
}

int workable(const Field& field, double swath_m, double margin_m = 0.0) {
  const auto grid = field_grid(field, metres(swath_m), metres(margin_m));
  return grid ? workable(*grid) : 0;
}

TEST_CASE("grid: cells that touch the edge from inside are workable", "[planner]") {
  CHECK(workable(paper_case::field(100, 400), 2) == 50 * 200);
  // Swaths that do not divide the field leave a rim: floor(100 / 3) x floor(400 / 3).
  CHECK(workable(paper_case::field(100, 400), 3) == 33 * 133);
  // 1 / 0.1 is not a whole number in binary; the rim must not swallow a column.
  CHECK(workable(paper_case::field(0.7, 0.3), 0.1) == 7 * 3);
}

TEST_CASE("grid: a slanted edge takes every cell that it crosses", "[planner]") {
  // Field A: 30 columns of 350; under the slope column k = 0 .. 19 has 330 + k, for its upper left
  // corner lies at y = 660 + 2 k.
  CHECK(workable(paper_case::field_a(), 2) == 30 * 350 + 20 * 330 + 190);
}

TEST_CASE("grid: follows the field's own corner, and either orientation", "[planner]") {
  Field field{.boundary = {at_m(-3, 7), at_m(-3, 13), at_m(5, 13), at_m(5, 7)},
              .holes = {},
              .obstacles = {}};
  const auto grid = field_grid(field, metres(2), Length{});

  REQUIRE(grid);
  CHECK(grid->origin == at_m(-3, 7));
  CHECK(grid->center(0, 0) == at_m(-2, 8));
  CHECK(workable(*grid) == 4 * 3);
}

TEST_CASE("grid: ways between centres keep the safety distance from obstacles", "[planner]") {
  Field field = paper_case::field(20, 20);
  const auto left = [&](double safety_m) {
    return workable(*field_grid(field, metres(2), {}, metres(safety_m)));
  };
  SECTION("half a cell is kept by every cell that is not touched") {
    field.obstacles = {{"post", at_m(9, 9), metres(0.5)}};
    CHECK(left(0) == 99);
    CHECK(left(1) == 99);
  }
  SECTION("further away cells are left out by the distance of their centres") {
    // Centres must be sqrt(2.5^2 + 1^2) = 2.69 m from the edge, 3.19 m from the middle of the post:
    // 3 x 3 cells are nearer, the next at 4 m.
    field.obstacles = {{"post", at_m(9, 9), metres(0.5)}};
    CHECK(left(2.5) == 91);
  }
  SECTION("an outline as well") {
    // 4 x 4 m on cell edges: its own 4 cells, the 8 beside it 1 m from its walls, and the 4 at its
    // corners 1.41 m; 1.1 m need sqrt(1.1^2 + 1^2) = 1.49 m.
    field.obstacles = {outlined("barn", {at_m(8, 8), at_m(12, 8), at_m(12, 12), at_m(8, 12)})};
    CHECK(left(0) == 96);
    CHECK(left(1.1) == 84);
  }
}

TEST_CASE("grid: holes and obstacles take the cells they touch from within", "[planner]") {
  Field field = paper_case::field(20, 20);

  SECTION("a hole smaller than a cell takes that cell") {
    field.holes.push_back({at_m(4.5, 4.5), at_m(5.5, 4.5), at_m(5, 5.5)});
    CHECK(workable(field, 2) == 99);
  }
  SECTION("a hole along cell edges takes its own cells only") {
    field.holes.push_back({at_m(4, 4), at_m(8, 4), at_m(8, 8), at_m(4, 8)});
    CHECK(workable(field, 2) == 96);
  }
  SECTION("a circle that fills a cell exactly takes no other") {
    field.obstacles.push_back({"mast", at_m(5, 5), metres(1)});
    CHECK(workable(field, 2) == 99);
  }
  SECTION("a circle on a corner takes the four cells around it, however small") {
    field.obstacles.push_back({"post", at_m(6, 6), metres(0.1)});
    CHECK(workable(field, 2) == 96);
  }
  SECTION("a circle does not take cells that its bounding square only meets") {
    // Centre (10, 10), radius 2.5: of the 4 x 4 cells around, the corner ones begin at distance
    // hypot(2, 2) = 2.83 m.
    field.obstacles.push_back({"tree", at_m(10, 10), metres(2.5)});
    CHECK(workable(field, 2) == 88);
  }
}

TEST_CASE("grid: holes that overlap, touch the boundary or lie outside are taken out once",
          "[planner]") {
  Field field = paper_case::field(10, 10);
  field.holes.push_back({at_m(2, 2), at_m(5, 2), at_m(5, 5), at_m(2, 5)});
  field.holes.push_back({at_m(4, 4), at_m(7, 4), at_m(7, 7), at_m(4, 7)});
  field.holes.push_back({at_m(8, 0), at_m(10, 0), at_m(10, 1), at_m(8, 1)});
  field.holes.push_back({at_m(20, 20), at_m(22, 20), at_m(21, 22)});
  const auto grid = field_grid(field, metres(1), Length{});
  REQUIRE(grid);
  // 9 + 9 cells less the one in both, and 2 of 100.
  CHECK(std::count(grid->workable.begin(), grid->workable.end(), 1) == 100 - 17 - 2);
}

TEST_CASE("grid: a margin draws boundary and holes in, corners mitred", "[planner]") {
  Field field = paper_case::field(20, 20);
  CHECK(workable(field, 2, 2) == 8 * 8);
  // The grid keeps its origin: an inset of 1 m cuts the outer cells, 1 m wide.
  CHECK(workable(field, 2, 1) == 8 * 8);

  field.holes.push_back({at_m(8, 8), at_m(12, 8), at_m(12, 12), at_m(8, 12)});
  CHECK(workable(field, 2, 2) == 8 * 8 - 4 * 4);
  CHECK(field_grid(field, metres(2), metres(20)).error().fault == PlanFault::margin_too_wide);
}

TEST_CASE("grid: broken outlines are refused with the place of the fault", "[planner]") {
  SECTION("a boundary that crosses itself") {
    const Field bow{.boundary = {at_m(0, 0), at_m(10, 10), at_m(10, 0), at_m(0, 10)},
                    .holes = {},
                    .obstacles = {}};
    const auto grid = field_grid(bow, metres(1), Length{});
    REQUIRE_FALSE(grid);
    CHECK(grid.error().fault == PlanFault::field_invalid);
    CHECK_THAT(grid.error().detail, Contains("Self-intersection at (5.000, 5.000) m"));
  }
  SECTION("no area, no ring, no number") {
    const Ring flat{at_m(0, 0), at_m(5, 0), at_m(9, 0)};
    const Ring two{at_m(0, 0), at_m(5, 0)};
    const Ring endless{at_m(0, 0), at_m(5, 0), at_m(5, std::numeric_limits<double>::infinity())};
    for (const Ring& ring : {flat, two, endless, Ring{}}) {
      const Field field{.boundary = ring, .holes = {}, .obstacles = {}};
      CHECK(field_grid(field, metres(1), Length{}).error().fault == PlanFault::field_invalid);
    }
  }
  SECTION("an obstacle that is no circle") {
    Field field = paper_case::field(10, 10);
    field.obstacles.push_back({"pond", at_m(5, std::nan("")), metres(1)});
    const auto grid = field_grid(field, metres(1), Length{});
    REQUIRE_FALSE(grid);
    CHECK(grid.error().fault == PlanFault::field_invalid);
    CHECK_THAT(grid.error().detail, Contains("pond"));
  }
  SECTION("more cells than anyone sprays") {
    CHECK(field_grid(paper_case::field(1e6, 1e6), metres(1), Length{}).error().fault ==
          PlanFault::field_invalid);
  }
  SECTION("a field narrower than the swath") {
    CHECK(field_grid(paper_case::field(1, 100), metres(2), Length{}).error().fault ==
          PlanFault::nothing_to_spray);
  }
}

// Whether `p` lies inside the convex, counter-clockwise ring, edges included.
bool inside(const Ring& ring, FieldPoint p) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const FieldVector edge = ring[(i + 1) % ring.size()] - ring[i], to = p - ring[i];
    if ((edge.x * to.y - edge.y * to.x).base() < -1e-9) return false;
  }
  return true;
}

TEST_CASE("grid: on convex fields a cell is workable just when its corners are inside",
          "[planner]") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    Random random{seed};
    Field field{};
    const double turn = random.uniform(0.0, 1.0), aspect = random.uniform(0.3, 1.0);
    for (int k = 0; k < 7; ++k) {  // seven places around an ellipse
      const double angle = turn + (k + random.uniform(0.0, 0.8)) * 2.0 * 3.14159265 / 7.0;
      field.boundary.push_back(at_m(30.0 * std::cos(angle), 30.0 * aspect * std::sin(angle)));
    }
    const auto grid = field_grid(field, metres(2), Length{});
    REQUIRE(grid);
    for (std::int32_t row = 0; row < grid->rows; ++row) {
      for (std::int32_t column = 0; column < grid->columns; ++column) {
        const FieldPoint c = grid->center(column, row);
        bool expected = true;
        for (const FieldVector corner :
             {FieldVector{metres(1), metres(1)}, FieldVector{metres(-1), metres(1)},
              FieldVector{metres(1), metres(-1)}, FieldVector{metres(-1), metres(-1)}}) {
          expected = expected && inside(field.boundary, c + corner);
        }
        if (grid->workable[grid->index(column, row)] != expected) {
          FAIL("cell " << column << ", " << row);
        }
      }
    }
  }
}

TEST_CASE("cells that an outlined obstacle touches are not workable") {
  // A triangle over (4 .. 8, 4 .. 8) of a field of 10 x 10 cells of 1 m: on row y, 4 <= y < 8, it
  // reaches from x = 4 to 8 - (y - 4): it touches 4, 3, 2 and 1 cells from column 4 on.
  const Field field{.boundary = {at_m(0, 0), at_m(10, 0), at_m(10, 10), at_m(0, 10)},
                    .holes = {},
                    .obstacles = {outlined("shed", {at_m(4, 4), at_m(8, 4), at_m(4, 8)})}};
  const auto grid = field_grid(field, metres(1), Length{});
  REQUIRE(grid);
  CHECK(std::count(grid->workable.begin(), grid->workable.end(), 1) == 100 - 10);
  CHECK(grid->workable[grid->index(4, 7)] == 0);
  CHECK(grid->workable[grid->index(5, 7)] == 1);
}

}  // namespace
}  // namespace furrow::planner
