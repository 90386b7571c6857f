#include "planner/fleet/solve.hpp"
#include "planner/fleet/bound.hpp"
#include "planner/fleet/cut_plan.hpp"
#include "planner/fleet/till_empty.hpp"
#include "tests/planner/fleet/enumerated.hpp"
#include "tests/planner/fleet/yardsticks.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner::fleet {
namespace {

/// Whether the sorties spray the path from its begin to its end, each place once.
bool covers_once(const FleetProblem& p, FleetSorties sorties) {
  std::sort(sorties.begin(), sorties.end(),
            [](const Sortie& a, const Sortie& b) { return a.from_m < b.from_m; });
  double at_m = 0.0;
  for (const Sortie& s : sorties) {
    if (s.from_m != at_m || s.to_m <= s.from_m) return false;
    at_m = s.to_m;
  }
  return at_m == p.path.length_m();
}

TEST_CASE("every change of a plan keeps the path covered once and within tanks") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const FleetProblem p = enumerated::random_problem(seed);
    const auto start = till_empty(p);
    REQUIRE(start);
    CutPlan plan{p, *start};
    Random random{seed};
    for (int i = 0; i < 300; ++i) {
      plan.change(random);
      REQUIRE(covers_once(p, plan.sorties()));
      REQUIRE(is_carried(p, plan.sorties()));
    }
  }
}

TEST_CASE("solved fleets of field A meet the makespans to beat") {
  for (const yardsticks::Yardstick& y : yardsticks::all) {
    CAPTURE(y.service_s, y.bays, y.fliers);
    const FleetProblem p = yardsticks::problem(y);
    const auto solution = solved(p);
    REQUIRE(solution);
    CHECK(solution->finish.makespan_s <= y.to_beat_s);
    CHECK(solution->finish.makespan_s >= y.bound_s);
    CHECK(covers_once(p, solution->sorties));
    CHECK(is_carried(p, solution->sorties));
    CHECK(QueueClock{p}.finish(solution->sorties).makespan_s == solution->finish.makespan_s);
  }
}

TEST_CASE("the same seed and budget give the same fleet plan") {
  const FleetProblem p = yardsticks::problem(yardsticks::all[0]);
  const auto one = solved(p, {.budget = 300'000, .seed = 7});
  const auto two = solved(p, {.budget = 300'000, .seed = 7});
  REQUIRE(one);
  REQUIRE(two);
  CHECK(one->finish.makespan_s == two->finish.makespan_s);
  REQUIRE(one->sorties.size() == two->sorties.size());
  for (std::size_t i = 0; i < one->sorties.size(); ++i)
    CHECK(one->sorties[i].to_m == two->sorties[i].to_m);
  CHECK(one->evaluations == two->evaluations);
}

void check_random_cases(std::uint64_t first, std::uint64_t cases) {
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    CAPTURE(seed);
    const FleetProblem p = enumerated::random_problem(seed);
    const auto solution = solved(p, {.budget = 10'000, .seed = seed});
    REQUIRE(solution);
    CHECK(solution->finish.makespan_s <= solution->till_empty_s);
    CHECK(solution->finish.makespan_s <= solution->simple_s);
    CHECK(solution->finish.makespan_s >= best_bound(p).makespan_s - 1e-6);
    CHECK(covers_once(p, solution->sorties));
  }
}

TEST_CASE("solved fleets are never later than till empty or simple, nor earlier than a bound") {
  check_random_cases(0, 60);
}

TEST_CASE("a thousand random fleets are never later than till empty or simple", "[.]") {
  check_random_cases(1'000, 1'000);
}

TEST_CASE("one aircraft's solved plan attains its bound") {
  yardsticks::Yardstick y = yardsticks::all[0];
  y.fliers = 1;
  const FleetProblem p = yardsticks::problem(y);
  const auto solution = solved(p);
  REQUIRE(solution);
  const LowerBound bound = best_bound(p);
  CHECK(bound.name == "work");
  CHECK(solution->finish.makespan_s < bound.makespan_s * 1.0005);
}

TEST_CASE("solved small cases are no later than all plans that cut on a grid") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const FleetProblem p = enumerated::random_problem(seed);
    const double grid_s = enumerated::best_makespan_s(p, enumerated::cuts_apart_m(p, 5));
    const auto solution = solved(p, {.budget = 200'000, .seed = 3});
    REQUIRE(solution);
    CHECK(solution->finish.makespan_s <= grid_s * 1.001);
  }
}

TEST_CASE("fleets whose packs are short stay within them, and hopeless ones are refused") {
  FleetProblem p = yardsticks::problem(yardsticks::all[0]);
  for (Flier& f : p.fliers) f.pack_s = 500;
  const auto solution = solved(p, {.budget = 300'000});
  REQUIRE(solution);
  CHECK(is_carried(p, solution->sorties));
  for (Flier& f : p.fliers) f.pack_s = 200;  // 700 m away and back take 280 s
  CHECK_FALSE(solved(p));
}

TEST_CASE("no flier of a solved fleet lands after its end, nor leaves before it is ready") {
  FleetProblem p = yardsticks::problem(yardsticks::all[0]);
  const auto free = solved(p, {.budget = 200'000});
  REQUIRE(free);
  const double half_s = 0.5 * free->finish.makespan_s;
  p.fliers[0].until_s = half_s;
  p.fliers[1].ready_s = half_s;
  const auto solution = solved(p, {.budget = 200'000});
  REQUIRE(solution);
  CHECK(solution->finish.late_s == 0);
  CHECK(solution->finish.makespan_s > free->finish.makespan_s);
  const Timetable times = QueueClock{p}.timetable(solution->sorties);
  std::size_t by_first = 0;
  for (std::size_t i = 0; i < solution->sorties.size(); ++i) {
    const std::uint32_t flier = solution->sorties[i].flier;
    if (flier == 0) {
      CHECK(times.lands_s[i] <= half_s);
      ++by_first;
    }
    if (flier == 1) CHECK(times.leaves_s[i] >= half_s);
  }
  CHECK(by_first > 0);
}

TEST_CASE("landing late costs more than any makespan") {
  const Finish late{.makespan_s = 10, .total_s = 10, .wait_s = 0, .late_s = 1};
  const Finish slow{.makespan_s = 99, .total_s = 99, .wait_s = 0, .late_s = 0};
  CHECK(is_better(slow, late));
  CHECK_FALSE(is_better(late, slow));
}

}  // namespace
}  // namespace furrow::planner::fleet
