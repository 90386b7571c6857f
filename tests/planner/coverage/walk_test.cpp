#include "planner/coverage/walk.hpp"

#include "tests/planner/paper_case.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

namespace furrow::planner {
namespace {

using Catch::Matchers::WithinAbs;

Expected<Route, PlanError> covered(const Field& field, const CoverageSettings& settings = {}) {
  return coverage_route(field, metres(2), settings);
}

// Every law that a route keeps, whatever the field.
void check_consistent(const Route& route) {
  std::set<std::pair<double, double>> once;
  for (const FieldPoint p : route.centers) once.insert({p.x.base(), p.y.base()});
  CHECK(once.size() == route.centers.size());
  for (const FieldPoint p : route.missed) CHECK(once.count({p.x.base(), p.y.base()}) == 0);
  REQUIRE_FALSE(route.strips.empty());
  CHECK_FALSE(route.strips.front().continues);
  std::uint32_t next = 0;
  for (const Strip& s : route.strips) {
    REQUIRE(s.cells.first == next);
    next = end(s.cells);
    REQUIRE(next <= route.centers.size());
    CHECK(s.from == route.centers[s.cells.first]);
    CHECK(s.to == route.centers[next - 1]);
    const double moves = s.cells.count - 1.0;
    CHECK_THAT(distance(s.from, s.to).base(), WithinAbs(moves * route.cell.base(), 1e-6));
    if (s.continues) {
      const FieldPoint before = route.centers[s.cells.first - 1];
      CHECK_THAT(distance(before, s.from).base(), WithinAbs(route.cell.base(), 1e-6));
    }
  }
  CHECK(next == route.centers.size());
}

std::size_t ferries(const Route& route) {
  return static_cast<std::size_t>(std::count_if(route.strips.begin() + 1, route.strips.end(),
                                                [](const Strip& s) { return !s.continues; }));
}

TEST_CASE("walk: field A is covered but for the cells the slanted edge leaves behind",
          "[planner]") {
  const Route route = paper_case::route(paper_case::field_a());

  check_consistent(route);
  // 30 columns of 350 cells, and 20 under the slope with 330, 331, ..., 349: 17290 workable cells.
  // A strip down from the lower column beside it misses its own top cell: x = 3, 7, ..., 39.
  CHECK(route.centers.size() == 17'280);
  std::vector<FieldPoint> expected;
  for (int x = 3; x <= 39; x += 4) expected.push_back(at_m(x, 659 + x - 1));
  std::vector<FieldPoint> missed = route.missed;
  std::sort(missed.begin(), missed.end(), [](auto a, auto b) { return a.x < b.x; });
  CHECK(missed == expected);
  CHECK(route.strips.size() == 50);
  CHECK(ferries(route) == 0);
  CHECK(route.centers[0] == at_m(1, 1));
  CHECK(route.centers[1] == at_m(1, 3));
  CHECK(route.strips[1].from == at_m(3, 659));
}

TEST_CASE("walk: strips lie along the work direction and advance away from the start",
          "[planner]") {
  struct Case {
    double direction_deg;
    FieldPoint start, second, across;
  };
  // A 10 m x 6 m field: 5 columns of 3 cells. `across` starts the second strip.
  const Case c = GENERATE(
      Case{0, at_m(1, 1), at_m(1, 3), at_m(3, 5)}, Case{360, at_m(1, 1), at_m(1, 3), at_m(3, 5)},
      Case{180, at_m(9, 5), at_m(9, 3), at_m(7, 1)}, Case{90, at_m(1, 1), at_m(3, 1), at_m(9, 3)},
      Case{-90, at_m(9, 5), at_m(7, 5), at_m(1, 3)}, Case{270, at_m(9, 1), at_m(7, 1), at_m(1, 3)},
      Case{180, at_m(1, 1), at_m(1, 3), at_m(3, 5)});
  CAPTURE(c.direction_deg, c.start.x.base(), c.start.y.base());
  const auto route =
      covered(paper_case::field(10, 6), {.work_direction_deg = c.direction_deg, .start = c.start});

  REQUIRE(route);
  check_consistent(*route);
  CHECK(route->centers.size() == 15);
  CHECK(route->missed.empty());
  CHECK(ferries(*route) == 0);
  CHECK(route->centers[0] == c.start);
  CHECK(route->centers[1] == c.second);
  CHECK(route->strips[1].from == c.across);
}

TEST_CASE("walk: without a start it begins in the corner nearest the station", "[planner]") {
  const auto route = covered(paper_case::field(10, 6), {.near = at_m(12, 9)});

  REQUIRE(route);
  CHECK(route->centers[0] == at_m(9, 5));
  CHECK(covered(paper_case::field(10, 6))->centers[0] == at_m(1, 1));
}

TEST_CASE("walk: ground behind a hole is flown to, not forgotten", "[planner]") {
  Field field = paper_case::field(40, 40);
  field.holes.push_back({at_m(10, 10), at_m(30, 10), at_m(30, 30), at_m(10, 30)});
  const auto route = covered(field);

  REQUIRE(route);
  check_consistent(*route);
  CHECK(route->centers.size() == 400 - 100);
  CHECK(route->missed.empty());
  CHECK(ferries(*route) >= 1);
}

TEST_CASE("walk: two fields in one outline joined by a gap too narrow to work", "[planner]") {
  // Two squares of 10 x 10 cells joined by a lane 1 m wide.
  const Field field{.boundary = {at_m(0, 0), at_m(20, 0), at_m(20, 9.5), at_m(30, 9.5), at_m(30, 0),
                                 at_m(50, 0), at_m(50, 20), at_m(30, 20), at_m(30, 10.5),
                                 at_m(20, 10.5), at_m(20, 20), at_m(0, 20)},
                    .holes = {},
                    .obstacles = {}};
  const auto route = covered(field);

  REQUIRE(route);
  check_consistent(*route);
  CHECK(route->centers.size() == 200);
  CHECK(ferries(*route) == 1);

  SECTION("the second is reported missed where regions of its size are not worth the flight") {
    const auto part = covered(field, {.min_region_cells = 101});
    REQUIRE(part);
    CHECK(part->centers.size() == 100);
    CHECK(part->missed.size() == 100);
  }
}

TEST_CASE("walk: a slope that falls away is stepped down by short ferries", "[planner]") {
  // Columns of 5, 4, 3, 2, 1 cells: at the top of the first there is no neighbour to move to.
  const Field field{
      .boundary = {at_m(0, 0), at_m(12, 0), at_m(0, 12)}, .holes = {}, .obstacles = {}};
  const auto route = covered(field, {.min_region_cells = 1});

  REQUIRE(route);
  check_consistent(*route);
  CHECK(route->centers.size() == 15);
  CHECK(route->missed.empty());
}

TEST_CASE("walk: says why it cannot start", "[planner]") {
  const Field field = paper_case::field_a();

  CHECK(covered(field, {.work_direction_deg = 45}).error().fault ==
        PlanFault::direction_unsupported);
  CHECK(covered(field, {.work_direction_deg = std::nan("")}).error().fault ==
        PlanFault::direction_unsupported);
  // Under the cut; and off the grid.
  CHECK(covered(field, {.start = at_m(1, 690)}).error().fault == PlanFault::start_not_workable);
  CHECK(covered(field, {.start = at_m(-1, 1)}).error().fault == PlanFault::start_not_workable);
}

}  // namespace
}  // namespace furrow::planner
