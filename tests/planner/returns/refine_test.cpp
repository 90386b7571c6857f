#include "planner/returns/refine.hpp"

#include "planner/returns/evaluate.hpp"
#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"
#include "planner/returns/window_search.hpp"
#include "tests/planner/paper_case.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

namespace furrow::planner {
namespace {

const ReturnProblem& field_a() {
  static const ReturnProblem problem =
      paper_case::problem(paper_case::route(paper_case::field_a()));
  return problem;
}

constexpr double optimum_a_s = 1090.087;

TEST_CASE("Refinement leads from the plans without a search to within half a percent") {
  const ExtraCost none;
  ReturnObjective objective{field_a(), none};
  for (const auto& plan : {simple_plan(field_a()), unplanned_plan(field_a())}) {
    const FoundReturns better = refined(field_a(), plan->returns, objective);
    const ReturnPlan judged = evaluated(field_a(), better.returns);
    CHECK(is_feasible(field_a(), judged));
    CHECK(judged.non_spray_s == better.objective_s);
    CHECK(better.objective_s <= 1.005 * optimum_a_s);
    CHECK(better.objective_s >= optimum_a_s - 0.001);
  }
}

TEST_CASE("Refinement minimises the extra cost together with the non-spray time") {
  // 100 s for every return beyond twelve, the least that tanks allow.
  const ExtraCost extra = [](const ReturnPlan& plan) {
    return 100.0 * static_cast<double>(std::max<std::size_t>(plan.returns.size(), 12) - 12);
  };
  ReturnObjective objective{field_a(), extra};
  const Returns start = simple_plan(field_a())->returns;
  const FoundReturns better = refined(field_a(), start, objective);
  const ReturnPlan plan = evaluated(field_a(), better.returns);
  CHECK(better.objective_s == plan.non_spray_s + extra(plan));
  CHECK(better.objective_s < objective(start));
}

TEST_CASE("Refinement moves a return for an extra cost alone") {
  // 60 x 120 m: 1800 cells, more than the 1351 of one tank, so one return between cells 449 and
  // 1350. At cell 1000 it is free, elsewhere it costs 100 s for each cell of distance; a cell's
  // move changes the non-spray time by less than a second.
  const ReturnProblem small = paper_case::problem(paper_case::route(paper_case::field(60, 120)));
  const ExtraCost extra = [](const ReturnPlan& plan) {
    if (plan.returns.size() != 1) return 1e6;
    return 100.0 * std::abs(static_cast<double>(plan.returns[0]) - 1000.0);
  };
  ReturnObjective objective{small, extra};
  CHECK(refined(small, {900}, objective).returns == Returns{1000});
}

TEST_CASE("A refinement that may judge no move still searches its windows, and no more") {
  const ExtraCost none;
  ReturnObjective objective{field_a(), none};
  const Returns start = unplanned_plan(field_a())->returns;
  CHECK(refined(field_a(), start, objective, 0).objective_s < objective(start));
}

TEST_CASE("Returns that no tank lasts for are mended, whatever the extra cost of those that work") {
  const ExtraCost extra = [](const ReturnPlan&) { return 1e7; };
  ReturnObjective objective{field_a(), extra};
  CHECK_FALSE(objective.is_feasible(Returns{9000}));
  CHECK(objective.is_feasible(refined(field_a(), {9000}, objective).returns));
}

TEST_CASE("Windows hold the cells around each return and the strip ends, once each") {
  const std::vector<std::uint32_t> returns = {5, 12}, ends = {0, 9, 10, 20};
  // Around 5: 1 3 5 7 9; around 12: 8 10 12 14 16; the ends 9 and 10 besides, first and last not.
  CHECK(cells_in({.stride = 2, .half_width = 4}, returns, ends, 20) ==
        std::vector<std::uint32_t>{1, 3, 5, 7, 8, 9, 10, 12, 14, 16});
  // Near the beginning a window is cut: -3 is left out of -3 1 5 9 13.
  CHECK(cells_in({.stride = 4, .half_width = 8}, std::vector<std::uint32_t>{5}, {}, 20) ==
        std::vector<std::uint32_t>{1, 5, 9, 13});
}

TEST_CASE("The best plan among given cells is theirs alone") {
  const ReturnCost cost{field_a()};
  const BatteryFree free = battery_free(legs_of(field_a()));
  const double infinite = std::numeric_limits<double>::infinity();
  const Returns unplanned = unplanned_plan(field_a())->returns;
  CHECK(best_among(cost, free, unplanned, infinite) == unplanned);
  // Nothing beats a cutoff below the optimum, and nothing goes through no cell at all.
  CHECK(best_among(cost, free, unplanned, 1000.0).empty());
  CHECK(best_among(cost, free, {}, infinite).empty());
}

}  // namespace
}  // namespace furrow::planner
