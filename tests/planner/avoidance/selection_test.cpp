#include "planner/avoidance/selection.hpp"

#include "core/random.hpp"
#include "planner/avoidance/field_options.hpp"
#include "planner/avoidance/genetic.hpp"

#include <catch2/catch.hpp>
#include <iostream>

using namespace furrow;
using namespace furrow::planner;

namespace {

// Two crowds whose cheap options spray the same ground.
SelectionProblem two_crowds() {
  return {.crowds = {{{1, 10}, {2, 20}}, {{1, 10}, {3, 15}}},
          .interplays = {{0, 1, {30, 0, 0, 5}}},
          .straight_m = 100,
          .planned_m2 = 1000};
}

// One pass of 400 m with up to twelve obstacles between neighbours.
SelectionProblem random_pass(std::uint64_t seed) {
  Random random{seed};
  const std::size_t obstacles = 1 + random.below(12);
  std::vector<CircleM> circles;
  for (std::size_t i = 0; i < obstacles; ++i) {
    circles.push_back({{random.uniform(15, 385), random.uniform(-3, 3)}, random.uniform(2.5, 4.5)});
  }
  const std::vector<PassM> passes{{{0, 0}, {400, 0}, 6}};
  return FieldOptions{passes, Room{circles, {}, {}}, 3}.problem(0.5, 0.5);
}

// Every selection, one after another.
double enumerated_fitness(const SelectionProblem& p) {
  Selection trial(p.crowds.size(), 0);
  double least = INFINITY;
  for (;;) {
    least = std::min(least, fitness(p, trial));
    std::size_t k = 0;
    while (k < trial.size() && ++trial[k] == p.crowds[k].size()) trial[k++] = 0;
    if (k == trial.size()) return least;
  }
}

}  // namespace

TEST_CASE("fitness weighs length and area over those of the straight passes") {
  // 0.5 (100 + 1 + 1) / 100 + 0.5 (10 + 10 + 30) / 1000 = 0.51 + 0.025.
  CHECK(fitness(two_crowds(), {0, 0}) == Approx(0.535));
  // 0.5 (100 + 1 + 3) / 100 + 0.5 (10 + 15) / 1000 = 0.52 + 0.0125.
  CHECK(fitness(two_crowds(), {0, 1}) == Approx(0.5325));
}

TEST_CASE("the exact selection knows what two crowds do to each other") {
  // 0.535, 0.5325, and {1, 0}: 0.515 + 0.015 = 0.53, {1, 1}: 0.525 + 0.02.
  CHECK(greedy_selection(two_crowds()) == Selection{0, 0});
  CHECK(exact_selection(two_crowds()) == Selection{1, 0});
}

TEST_CASE("the exact selection is the best of all") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SelectionProblem p{.crowds = {}, .interplays = {}, .straight_m = 100, .planned_m2 = 500};
    Random random{seed};
    const std::size_t crowds = 2 + random.below(5);
    for (std::size_t i = 0; i < crowds; ++i) {
      p.crowds.emplace_back();
      for (std::size_t o = 0; o < 2 + random.below(2); ++o) {
        p.crowds.back().push_back({random.uniform(0, 5), random.uniform(0, 40)});
      }
    }
    for (std::size_t a = 0; a < crowds; ++a) {
      for (std::size_t b = a + 1; b < crowds; ++b) {
        if (seed % 2 == 0 ? b > a + 1 : random.uniform() < 0.5) continue;  // chains, and others
        Interplay i{a, b, {}};
        for (std::size_t k = 0; k < p.crowds[a].size() * p.crowds[b].size(); ++k) {
          i.wrong_m2.push_back(random.uniform(-20, 30));
        }
        p.interplays.push_back(i);
      }
    }
    const auto exact = exact_selection(p);
    REQUIRE(exact);
    CHECK(fitness(p, *exact) == Approx(enumerated_fitness(p)).epsilon(1e-12));
  }
}

TEST_CASE("no exact selection is claimed where there are too many") {
  SelectionProblem p = two_crowds();
  p.crowds.push_back({{1, 1}, {2, 2}});
  p.interplays.push_back({0, 2, {1, 2, 3, 4}});  // with {0, 1} no chain: 8 selections
  CHECK_FALSE(exact_selection(p, 7));
  CHECK(exact_selection(p, 8));
}

TEST_CASE("genetic search finds the optimum of random passes") {
  int equal = 0;
  double worst = 0;
  constexpr int passes = 200;
  for (std::uint64_t seed = 0; seed < passes; ++seed) {
    const SelectionProblem p = random_pass(seed);
    const auto exact = exact_selection(p);
    REQUIRE(exact);
    const GeneticResult found = genetic_selection(p, {.seed = seed});
    const double gap = found.fitness / fitness(p, *exact) - 1;
    CHECK(gap >= -1e-12);
    if (gap <= 1e-12) ++equal;
    worst = std::max(worst, gap);
  }
  std::cout << "genetic search: optimum in " << equal << " of " << passes << " passes, worst gap "
            << worst << '\n';
  CHECK(equal >= 190);
}

TEST_CASE("genetic search is repeatable and stops at its target") {
  const SelectionProblem p = random_pass(3);
  const GeneticResult once = genetic_selection(p, {.seed = 5});
  CHECK(once.best == genetic_selection(p, {.seed = 5}).best);
  CHECK(once.iterations == 200);
  CHECK(genetic_selection(p, {.target_fitness = once.fitness, .seed = 5}).iterations < 200);
}
