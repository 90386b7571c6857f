#include "planner/returns/solve.hpp"

#include "planner/returns/evaluate.hpp"
#include "tests/planner/paper_case.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

const ReturnProblem& field_a() {
  static const ReturnProblem problem =
      paper_case::problem(paper_case::route(paper_case::field_a()));
  return problem;
}

constexpr SolveSettings settings(ReturnStrategy returns) {
  return {.returns = returns,
          .refine = true,
          .paper_counting = false,
          .iterations = 300,
          .masses = 50,
          .budget_s = 1.0,
          .seed = 1};
}

TEST_CASE("Every strategy is judged against the proven optimum of the paper's field") {
  // Non-spray time: unplanned by every move, simple 24.18 min, optimum 1090.087 s with 14 returns.
  const auto unplanned = solve(field_a(), settings(ReturnStrategy::unplanned));
  CHECK(unplanned->plan.returns.size() == 12);
  CHECK(unplanned->lower_bound_s == Approx(1090.087).margin(0.01));
  CHECK_FALSE(unplanned->proven);
  CHECK(unplanned->gsa_objective_s == 0.0);

  const auto simple = solve(field_a(), settings(ReturnStrategy::simple));
  CHECK(simple->objective_s / 60.0 == Approx(24.18).margin(0.005));
  CHECK_FALSE(simple->proven);

  const auto exact = solve(field_a(), settings(ReturnStrategy::exact));
  CHECK(exact->objective_s == Approx(1090.087).margin(0.01));
  CHECK(exact->plan.returns.size() == 14);
  CHECK(exact->proven);
}

TEST_CASE("Gravity and refinement come within half a percent, and both results are named") {
  const auto solution = solve(field_a(), settings(ReturnStrategy::gsa));
  CHECK(is_feasible(field_a(), solution->plan));
  CHECK(solution->objective_s == solution->plan.non_spray_s);
  CHECK(solution->objective_s <= 1.005 * solution->lower_bound_s);
  CHECK(solution->gsa_objective_s >= solution->objective_s);
  CHECK(solution->evaluations > 0);
  // Proven only where the bound is attained.
  CHECK(solution->proven == (solution->objective_s <= solution->lower_bound_s + 1e-9));
}

TEST_CASE("Without refinement the plan is that of gravity alone") {
  SolveSettings pure = settings(ReturnStrategy::gsa);
  pure.refine = false;
  const auto solution = solve(field_a(), pure);
  CHECK(solution->objective_s == solution->gsa_objective_s);
  CHECK(solution->objective_s < 1138.8);  // the paper's GSA, 18.98 min
}

TEST_CASE("Solving twice gives the same plan") {
  const auto once = solve(field_a(), settings(ReturnStrategy::gsa));
  const auto again = solve(field_a(), settings(ReturnStrategy::gsa));
  CHECK(once->plan.returns == again->plan.returns);
  CHECK(once->objective_s == again->objective_s);
  CHECK(once->evaluations == again->evaluations);
}

TEST_CASE("The paper's counting is a choice of the unplanned strategy") {
  SolveSettings paper = settings(ReturnStrategy::unplanned);
  paper.paper_counting = true;
  const auto solution = solve(field_a(), paper);
  CHECK(solution->plan.round_trips_m == Approx(6440).margin(0.5));
  CHECK_FALSE(solution->proven);
}

TEST_CASE("An extra cost joins the objective, and proves nothing") {
  const ExtraCost extra = [](const ReturnPlan& plan) {
    return 5.0 * static_cast<double>(plan.returns.size());
  };
  SolveSettings short_budget = settings(ReturnStrategy::gsa);
  short_budget.budget_s = 0.2;
  const auto solution = solve(field_a(), short_budget, extra);
  CHECK(solution->objective_s == solution->plan.non_spray_s + extra(solution->plan));
  CHECK(solution->objective_s >= solution->lower_bound_s);
  CHECK_FALSE(solution->proven);
}

TEST_CASE("The smallest budget still gives a feasible plan and a bound") {
  for (const auto strategy : {ReturnStrategy::gsa, ReturnStrategy::exact}) {
    SolveSettings least = settings(strategy);
    least.budget_s = 1e-6;
    const auto solution = solve(field_a(), least);
    CHECK(is_feasible(field_a(), solution->plan));
    CHECK(solution->lower_bound_s > 1000.0);
    CHECK(solution->lower_bound_s <= 1090.088);
  }
}

TEST_CASE("What cannot be flown is refused with its reason") {
  const Route route = paper_case::route(paper_case::field_a());
  Station far = paper_case::station();
  far.position = at_m(0, -20'000);
  const auto n = static_cast<std::uint32_t>(route.centers.size());
  const auto refused = solve(return_problem(route, {0, n}, paper_case::vehicle(), far),
                             settings(ReturnStrategy::gsa));
  REQUIRE_FALSE(refused);
  CHECK(refused.error().fault == PlanFault::out_of_reach);
}

}  // namespace
}  // namespace furrow::planner
