#include "planner/returns/gsa_returns.hpp"

#include "planner/returns/evaluate.hpp"
#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"
#include "tests/planner/paper_case.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner {
namespace {

const ReturnProblem& field_a() {
  static const ReturnProblem problem =
      paper_case::problem(paper_case::route(paper_case::field_a()));
  return problem;
}

constexpr GsaReturnsSettings quick{.masses = 50, .iterations = 300, .searches = 1, .seed = 1};

TEST_CASE("The light cost is that of the whole evaluation, to the last bit") {
  const ReturnCost cost{field_a()};
  for (const auto& plan : {simple_plan(field_a()), unplanned_plan(field_a())}) {
    const JudgedReturns judged = cost(plan->returns);
    CHECK(judged.non_spray_s == plan->non_spray_s);
    CHECK(judged.excess_s == 0.0);
  }
}

TEST_CASE("Sorties beyond tank and pack cost their excess in seconds") {
  // One sortie over all 17 280 cells: 17 279 moves of 2 m are 34 558 m, 31 858 m more than a tank,
  // or 10 619.33 s of spraying; its flight outlasts the pack as well.
  const ReturnCost cost{field_a()};
  const double flight_s = cost.flight_s(0, cost.last_cell());
  CHECK(cost({}).excess_s == Approx(10'619.333 + flight_s - 1500.0));
  CHECK(cost({}).non_spray_s == 0.0);
}

TEST_CASE("Whole shares stand for the unplanned plan") {
  const ReturnCost cost{field_a()};
  const ShareCode code{field_a(), cost};
  Returns returns;
  code.decode(std::vector<double>(22, 1.0), returns);
  CHECK(returns == unplanned_plan(field_a())->returns);
  code.decode({}, returns);
  CHECK(returns == unplanned_plan(field_a())->returns);
}

TEST_CASE("The simple plan survives being written as shares") {
  const ReturnCost cost{field_a()};
  const ShareCode code{field_a(), cost};
  const Returns simple = simple_plan(field_a())->returns;
  Returns returns;
  code.decode(code.encoded(simple, simple.size()), returns);
  CHECK(returns == simple);
}

TEST_CASE("Every point of the cube is a feasible plan") {
  const ReturnCost cost{field_a()};
  const ShareCode code{field_a(), cost};
  Returns returns;
  for (int tenths = 0; tenths <= 10; ++tenths) {
    code.decode(std::vector<double>(30, 0.1 * tenths), returns);
    CHECK(cost(returns).excess_s == 0.0);
  }
}

TEST_CASE("Gravity comes below the paper's own result on its field") {
  // Wang et al. 2017: 18.98 min = 1138.8 s by their GSA; the optimum is 1090.087 s.
  const ExtraCost none;
  ReturnObjective objective{field_a(), none};
  GsaReturnsSettings settings = quick;
  settings.searches = 5;
  const auto found = gsa_returns(field_a(), settings, objective);
  REQUIRE(found.size() == 5);
  CHECK(found.front().objective_s < 1138.8);
  CHECK(found.front().objective_s >= 1090.087 - 0.001);
  CHECK(found.front().objective_s <= found.back().objective_s);
  CHECK(evaluated(field_a(), found.front().returns).non_spray_s == found.front().objective_s);
  CHECK(objective.evaluations() == 5 * 50 * 301);
}

TEST_CASE("The same seed finds the same returns, another seed others") {
  const auto returns_of = [](std::uint64_t seed) {
    const ExtraCost none;
    ReturnObjective objective{field_a(), none};
    GsaReturnsSettings settings = quick;
    settings.seed = seed;
    return gsa_returns(field_a(), settings, objective).front().returns;
  };
  CHECK(returns_of(1) == returns_of(1));
  CHECK(returns_of(1) != returns_of(2));
}

TEST_CASE("A share that one tank sprays needs no return") {
  // 60 m x 40 m: 600 cells, 1198 m.
  const ReturnProblem small = paper_case::problem(paper_case::route(paper_case::field(60, 40)));
  const ExtraCost none;
  ReturnObjective objective{small, none};
  const auto found = gsa_returns(small, quick, objective);
  REQUIRE(found.size() == 1);
  CHECK(found.front().returns.empty());
  CHECK(found.front().objective_s == 0.0);
}

}  // namespace
}  // namespace furrow::planner
