// The figures of Wang et al. 2017 for field A, the rectangles of its table 3 and its field test.
#include "planner/returns/evaluate.hpp"
#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"
#include "tests/planner/paper_case.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace furrow::planner {
namespace {

using Catch::Matchers::WithinAbs;

// Half a unit of the last printed digit.
constexpr double to_metre = 0.5, to_tenth = 0.05, to_hundredth = 0.005;

std::uint32_t cell_at(const Route& route, FieldPoint place) {
  const auto found = std::find(route.centers.begin(), route.centers.end(), place);
  REQUIRE(found != route.centers.end());
  return static_cast<std::uint32_t>(found - route.centers.begin());
}

Returns returns_at(const Route& route, const std::vector<FieldPoint>& places) {
  Returns returns;
  for (const FieldPoint place : places) returns.push_back(cell_at(route, place));
  return returns;
}

std::vector<FieldPoint> places(const Route& route, const ReturnPlan& plan) {
  std::vector<FieldPoint> found;
  for (const std::uint32_t cell : plan.returns) found.push_back(route.centers[cell]);
  return found;
}

double filling_min(const ReturnPlan& plan) {
  double sum_s = 0.0;
  for (const PlannedSortie& s : plan.sorties) sum_s += s.fill_s;
  return sum_s / 60.0;
}

double service_min(const ReturnPlan& plan) {
  double sum_s = 0.0;
  for (const PlannedSortie& s : plan.sorties) sum_s += s.service_s;
  return sum_s / 60.0;
}

double flights_min(const ReturnPlan& plan) { return plan.round_trips_m / 6.0 / 60.0; }

// Table 4 without its end point.
const std::vector<FieldPoint>& table_4() {
  static const std::vector<FieldPoint> points{
      at_m(9, 1),   at_m(17, 1),  at_m(23, 11), at_m(31, 55), at_m(37, 45),
      at_m(43, 47), at_m(49, 49), at_m(55, 51), at_m(61, 49), at_m(67, 51),
      at_m(73, 49), at_m(79, 51), at_m(85, 49), at_m(91, 51), at_m(97, 49)};
  return points;
}

TEST_CASE("paper: the GSA plan of field A costs what the paper prints", "[planner]") {
  const Route route = paper_case::route(paper_case::field_a());
  const ReturnProblem problem = paper_case::problem(route);
  const ReturnPlan plan = evaluated(problem, returns_at(route, table_4()));

  CHECK(is_feasible(problem, plan));
  CHECK(plan.returns.size() == 15);
  CHECK_THAT(plan.round_trips_m, WithinAbs(2073, to_metre));
  CHECK_THAT(flights_min(plan), WithinAbs(5.8, to_tenth));
  CHECK(plan.swaps == 9);
  CHECK_THAT(filling_min(plan), WithinAbs(12.9, to_tenth));
  CHECK_THAT(service_min(plan), WithinAbs(13.2, to_tenth));
  CHECK_THAT(plan.non_spray_s / 60.0, WithinAbs(18.98, to_hundredth));
}

TEST_CASE("paper: the sorties of table 4 are as long as printed", "[planner]") {
  const Route route = paper_case::route(paper_case::field_a());
  const ReturnPlan plan = evaluated(paper_case::problem(route), returns_at(route, table_4()));

  CHECK(route.centers.back() == at_m(99, 1));
  const std::vector<double> expected_m{2648, 2680, 2700, 2700, 1484, 2700, 1496, 2700,
                                       1500, 2700, 1500, 2700, 1500, 2700, 1500, 1350};
  std::vector<double> found_m;
  for (const PlannedSortie& s : plan.sorties) found_m.push_back(s.spray_m);
  CHECK(found_m == expected_m);
}

TEST_CASE("paper: the packs of table 8 are used as printed", "[planner]") {
  const Route route = paper_case::route(paper_case::field_a());
  const ReturnPlan plan = evaluated(paper_case::problem(route), returns_at(route, table_4()));

  const std::vector<double> expected_percent{58.95, 59.85, 60.47, 95.31, 96.08,
                                             96.64, 97.05, 97.49, 97.95, 32.31};
  std::vector<double> found_percent(plan.swaps + 1, 0.0);
  for (const PlannedSortie& s : plan.sorties) found_percent[s.pack - 1] += 100.0 * s.battery_used;
  REQUIRE(found_percent.size() == expected_percent.size());
  for (std::size_t k = 0; k < expected_percent.size(); ++k) {
    CAPTURE(k);
    CHECK_THAT(found_percent[k], WithinAbs(expected_percent[k], to_hundredth));
  }
}

TEST_CASE("paper: the simple plan of field A costs what the paper prints", "[planner]") {
  const auto plan = simple_plan(paper_case::problem(paper_case::route(paper_case::field_a())));

  REQUIRE(plan);
  CHECK(plan->returns.size() == 22);
  CHECK_THAT(plan->round_trips_m, WithinAbs(2413, to_metre));
  CHECK_THAT(flights_min(*plan), WithinAbs(6.7, to_tenth));
  CHECK(plan->swaps == 8);
  CHECK_THAT(filling_min(*plan), WithinAbs(15.2, to_tenth));
  CHECK_THAT(service_min(*plan), WithinAbs(17.5, to_tenth));
  CHECK_THAT(plan->non_spray_s / 60.0, WithinAbs(24.18, to_hundredth));
}

TEST_CASE("paper: the unplanned flight of field A costs what the paper prints", "[planner]") {
  const Route route = paper_case::route(paper_case::field_a());
  const auto plan = unplanned_plan(paper_case::problem(route), Counting::straight_moves);

  REQUIRE(plan);
  const std::vector<FieldPoint> expected{
      at_m(9, 61),   at_m(17, 87),  at_m(25, 81),  at_m(33, 43),  at_m(39, 29),  at_m(47, 123),
      at_m(55, 217), at_m(63, 311), at_m(71, 405), at_m(79, 499), at_m(87, 593), at_m(95, 687)};
  CHECK(places(route, *plan) == expected);
  CHECK_THAT(plan->round_trips_m, WithinAbs(6440, to_metre));
  CHECK_THAT(flights_min(*plan), WithinAbs(17.9, to_tenth));
  CHECK(plan->swaps == 12);
  CHECK_THAT(filling_min(*plan), WithinAbs(11.9, to_tenth));
  CHECK_THAT(service_min(*plan), WithinAbs(12.0, to_tenth));
  CHECK_THAT(plan->non_spray_s / 60.0, WithinAbs(29.90, to_hundredth));
}

TEST_CASE("paper: counting every move, the unplanned flight returns a little earlier",
          "[planner]") {
  const Route route = paper_case::route(paper_case::field_a());
  const ReturnProblem problem = paper_case::problem(route);
  const auto plan = unplanned_plan(problem);

  REQUIRE(plan);
  CHECK(is_feasible(problem, *plan));
  CHECK(plan->returns.size() == 12);
  CHECK(places(route, *plan)[0] == at_m(9, 53));
  CHECK(places(route, *plan)[1] == at_m(17, 73));
  CHECK_THAT(plan->round_trips_m, WithinAbs(6878, to_metre));
}

TEST_CASE("paper: table 3 counts the returns on wider and wider fields", "[planner]") {
  const std::vector<std::pair<std::size_t, std::size_t>> unplanned_and_simple{
      {7, 8},     {14, 16},   {22, 24},   {29, 33},   {37, 41},   {44, 49},  {51, 58},
      {59, 66},   {66, 74},   {74, 83},   {81, 91},   {88, 99},   {96, 108}, {103, 116},
      {111, 124}, {118, 133}, {125, 141}, {133, 149}, {140, 158}, {148, 166}};
  for (std::size_t row = 0; row < unplanned_and_simple.size(); ++row) {
    const double wide_m = 100.0 * static_cast<double>(row + 1);
    CAPTURE(wide_m);
    const ReturnProblem p = paper_case::problem(paper_case::route(paper_case::field(wide_m, 400)));
    CHECK(unplanned_plan(p)->returns.size() == unplanned_and_simple[row].first);
    CHECK(simple_plan(p)->returns.size() == unplanned_and_simple[row].second);
  }
}

TEST_CASE("paper: the field test of table 5 returns twice", "[planner]") {
  const Route route = paper_case::route(paper_case::field(60, 200, 40));
  const auto plan = unplanned_plan(paper_case::problem(route), Counting::straight_moves);

  REQUIRE(plan);
  CHECK(places(route, *plan) == std::vector<FieldPoint>{at_m(31, 53), at_m(59, 103)});
  CHECK_THAT(plan->round_trips_m, WithinAbs(360, to_metre));
}

TEST_CASE("paper: the simple plan of field B takes 8 returns and 9.98 minutes", "[planner]") {
  const auto plan = simple_plan(paper_case::problem(paper_case::route(paper_case::field_b())));

  REQUIRE(plan);
  CHECK(plan->returns.size() == 8);
  CHECK_THAT(plan->non_spray_s / 60.0, WithinAbs(9.98, to_hundredth));
}

TEST_CASE("paper: condition (1) holds where the simple plan wastes less than the last tank",
          "[planner]") {
  // 20 m x 400 m: ten strips of 398 m joined by nine moves of 2 m are 3998 m, one return. Unplanned
  // at 2700 m; simple after six strips and six moves, at 2400 m. The last sortie sprays
  // 3998 - 2700 = 1298 m, so 300 m saved are within the 1402 m left in its tank.
  const ReturnProblem narrow = paper_case::problem(paper_case::route(paper_case::field(20, 400)));
  CHECK(simple_plan_suffices(narrow, *unplanned_plan(narrow), *simple_plan(narrow)));

  // Field A: 12 returns unplanned, 22 simple.
  const ReturnProblem wide = paper_case::problem(paper_case::route(paper_case::field_a()));
  CHECK_FALSE(simple_plan_suffices(wide, *unplanned_plan(wide), *simple_plan(wide)));
}

}  // namespace
}  // namespace furrow::planner
