#include "planner/returns/exact.hpp"

#include "core/random.hpp"
#include "planner/returns/evaluate.hpp"
#include "tests/planner/paper_case.hpp"

#include <catch2/catch.hpp>
#include <limits>

namespace furrow::planner {
namespace {

using Catch::Matchers::WithinAbs;

void resume_where_it_stopped(ReturnProblem& p) {
  p.resume_m = p.spray_m;
  p.resume_s = p.on_route_s;
  p.out_m = p.back_m;
  p.resume_m[0] = p.resume_s[0] = 0.0;
  p.out_m[0] = p.fly_out_m;
}

// A problem of a few cells with homes anywhere, ferries between some of them, and packs, tanks and
// services of any proportion.
ReturnProblem random_problem(std::uint64_t seed) {
  Random random{seed};
  Vehicle v = paper_case::vehicle();
  v.spray_endurance = seconds(random.uniform(2.0, 6.0) * 2.0 / 3.0);
  v.flight_endurance = seconds(random.uniform(4.0, 25.0));
  v.battery_reserve = random.below(2) ? 0.2 : 0.0;
  Station s = paper_case::station();
  s.battery_swap = seconds(random.uniform(0.0, 8.0));
  s.fill_base = seconds(random.uniform(0.0, 3.0));
  s.fill_full = s.fill_base + seconds(random.uniform(0.0, 6.0));
  const std::uint64_t cells = 2 + random.below(11);
  ReturnProblem p{.vehicle = v,
                  .station = s,
                  .cells = {0, static_cast<std::uint32_t>(cells)},
                  .spray_m = {},
                  .on_route_s = {},
                  .back_m = {},
                  .resume_m = {},
                  .resume_s = {},
                  .out_m = {},
                  .fly_out_m = random.uniform(0.0, 10.0),
                  .strip_starts = {0}};
  double spray_m = 0.0, jumps_s = 0.0;
  for (std::uint64_t i = 0; i < cells; ++i) {
    if (i > 0 && random.below(6) == 0) {
      jumps_s += random.uniform(0.0, 1.0);
      p.strip_starts.push_back(static_cast<std::uint32_t>(i));
    } else if (i > 0) {
      spray_m += 2.0;
    }
    p.spray_m.push_back(spray_m);
    p.on_route_s.push_back(spray_m / 3.0 + jumps_s);
    p.back_m.push_back(random.uniform(0.0, 12.0));
  }
  resume_where_it_stopped(p);
  return p;
}

// Like the above, but sprayed from end to end: strips of cells of 2 m, joined by ferries that a
// return at a strip's end replaces, also where they are longer than the round trip.
ReturnProblem random_ends_problem(std::uint64_t seed) {
  ReturnProblem p = random_problem(seed);
  Random random{seed_for(seed, {1})};
  p.strip_starts = {0};
  std::vector<double> ferries_s, outs_m;
  double ferried_s = 0.0;
  for (std::size_t i = 0; i < p.spray_m.size(); ++i) {
    p.spray_m[i] = 2.0 * static_cast<double>(i + 1);
    p.on_route_s[i] = p.spray_m[i] / 3.0 + ferried_s;
    const bool ends = i + 1 < p.spray_m.size() && random.below(3) == 0;
    if (ends) p.strip_starts.push_back(static_cast<std::uint32_t>(i + 1));
    ferries_s.push_back(ends ? random.uniform(0.0, 4.0) : 0.0);
    outs_m.push_back(ends ? random.uniform(0.0, 12.0) : p.back_m[i]);
    ferried_s += ferries_s.back();
  }
  resume_where_it_stopped(p);
  for (std::size_t i = 1; i < p.spray_m.size(); ++i) {
    p.resume_s[i] += ferries_s[i];
    p.out_m[i] = outs_m[i];
  }
  return p;
}

// Like the above on ground that is not level: any flight may take longer, and more of a pack.
ReturnProblem random_hill_problem(std::uint64_t seed) {
  ReturnProblem p = random_ends_problem(seed);
  Random random{seed_for(seed, {2})};
  HillFlights hills;
  double late_s = 0, climb_s = 0;
  for (std::uint32_t i = 0; i < p.cells.count; ++i) {
    const double back_s = p.back_s(i) + random.uniform(0, 1), out_s = p.out_s(i);
    hills.back.push_back({back_s, back_s + random.uniform(0, 1)});
    hills.out.push_back({out_s, out_s + random.uniform(0, 1)});
    late_s += random.uniform(0, 0.3);
    climb_s += random.uniform(0, 0.3);
    hills.late_s.push_back(late_s);
    hills.climb_s.push_back(climb_s);
    p.on_route_s[i] += late_s;
    if (i > 0) p.resume_s[i] += late_s;
  }
  hills.resume_late_s = hills.late_s;
  hills.resume_climb_s = hills.climb_s;
  hills.resume_late_s[0] = hills.resume_climb_s[0] = 0;
  p.hills = hills;
  return p;
}

// The least non-spray time over every set of return points; infinite if none is feasible.
double brute_force_s(const ReturnProblem& p) {
  const auto inner = static_cast<std::uint32_t>(p.spray_m.size() - 2);
  double best_s = std::numeric_limits<double>::infinity();
  for (std::uint32_t set = 0; set < 1u << inner; ++set) {
    Returns returns;
    for (std::uint32_t i = 0; i < inner; ++i) {
      if (set >> i & 1u) returns.push_back(i + 1);
    }
    const ReturnPlan plan = evaluated(p, returns);
    if (is_feasible(p, plan)) best_s = std::min(best_s, plan.non_spray_s);
  }
  return best_s;
}

TEST_CASE("exact: agrees with trying every set of return points", "[planner]") {
  const auto random = GENERATE(&random_problem, &random_ends_problem, &random_hill_problem);
  int solved = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    CAPTURE(seed);
    const ReturnProblem p = random(seed);
    const auto exact = exact_plan(p);
    if (!exact) continue;
    ++solved;
    CHECK(exact->proven);
    CHECK(is_feasible(p, exact->plan));
    CHECK_THAT(exact->plan.non_spray_s, WithinAbs(brute_force_s(p), 1e-6));
    CHECK(exact->lower_bound_s <= exact->plan.non_spray_s);
    CHECK(battery_free_bound_s(p) <= exact->plan.non_spray_s + 1e-9);
  }
  CHECK(solved > 100);
}

TEST_CASE("exact: a small budget leaves an honest gap", "[planner]") {
  const Route route = paper_case::route(paper_case::field_a());
  const ReturnProblem p = paper_case::problem(route);
  const std::uint64_t budget = GENERATE(0u, 10'000u, 600'000u, 1'000'000u, 2'000'000u);
  CAPTURE(budget);

  const auto exact = exact_plan(p, {.work_budget = budget});

  REQUIRE(exact);
  CHECK(exact->work <= budget);
  CHECK(is_feasible(p, exact->plan));
  CHECK(exact->plan.non_spray_s >= 1090.086);  // the optimum, below
  CHECK(exact->lower_bound_s <= 1090.088);
  CHECK(exact->lower_bound_s >= 1087.680);  // the battery-free bound costs no budget
  CHECK_FALSE(exact->proven);
}

TEST_CASE("exact: field A takes 1090.087 s and 14 returns", "[planner]") {
  const Route route = paper_case::route(paper_case::field_a());
  const ReturnProblem p = paper_case::problem(route);

  const auto exact = exact_plan(p);

  REQUIRE(exact);
  CHECK(exact->proven);
  CHECK_THAT(exact->plan.non_spray_s, WithinAbs(1090.087, 0.01));
  CHECK_THAT(exact->plan.round_trips_m, WithinAbs(2023.0, 0.5));
  CHECK(exact->plan.swaps == 9);
  CHECK_THAT(battery_free_bound_s(p), WithinAbs(1087.681, 0.001));
  const std::vector<FieldPoint> expected{at_m(7, 1),   at_m(17, 11), at_m(23, 1),   at_m(31, 45),
                                         at_m(37, 43), at_m(43, 49), at_m(49, 47),  at_m(55, 53),
                                         at_m(61, 97), at_m(67, 3),  at_m(75, 103), at_m(81, 49),
                                         at_m(87, 51), at_m(93, 99)};
  std::vector<FieldPoint> found;
  for (const std::uint32_t cell : exact->plan.returns) found.push_back(route.centers[cell]);
  CHECK(found == expected);
}

TEST_CASE("exact: field B takes 572.784 s and 8 returns", "[planner]") {
  const auto exact = exact_plan(paper_case::problem(paper_case::route(paper_case::field_b())));

  REQUIRE(exact);
  CHECK(exact->proven);
  CHECK_THAT(exact->plan.non_spray_s, WithinAbs(572.784, 0.001));
  CHECK(exact->plan.returns.size() == 8);
}

TEST_CASE("exact: a field of one sortie needs no return", "[planner]") {
  // 20 m x 20 m: 100 cells, 99 moves of 2 m, 198 m of 2700 m.
  const auto exact = exact_plan(paper_case::problem(paper_case::route(paper_case::field(20, 20))));

  REQUIRE(exact);
  CHECK(exact->proven);
  CHECK(exact->plan.returns.empty());
  CHECK(exact->plan.non_spray_s == 0.0);
}

TEST_CASE("exact: a single cell is a plan of one sortie", "[planner]") {
  const Route route = paper_case::route(paper_case::field_a());
  const auto exact =
      exact_plan(return_problem(route, {100, 1}, paper_case::vehicle(), paper_case::station()));

  REQUIRE(exact);
  CHECK(exact->proven);
  CHECK(exact->plan.sorties.size() == 1);
}

}  // namespace
}  // namespace furrow::planner
