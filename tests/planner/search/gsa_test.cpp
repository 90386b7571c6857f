#include "planner/search/gsa.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace furrow::planner {
namespace {

GsaProblem in_cube(std::size_t dimensions, double half_width, GsaObjective objective) {
  return {.low = std::vector<double>(dimensions, -half_width),
          .high = std::vector<double>(dimensions, half_width),
          .objective = std::move(objective)};
}

double sphere(std::span<const double> x) {
  double sum = 0.0;
  for (const double v : x) sum += v * v;
  return sum;
}

double rastrigin(std::span<const double> x) {
  double sum = 0.0;
  for (const double v : x) sum += v * v - 10.0 * std::cos(2.0 * std::numbers::pi * v) + 10.0;
  return sum;
}

double median_of_runs(const GsaProblem& problem, GsaSettings settings, std::uint64_t runs) {
  std::vector<double> values;
  for (settings.seed = 0; settings.seed < runs; ++settings.seed) {
    values.push_back(gsa_minimum(problem, settings).value);
  }
  std::nth_element(values.begin(), values.begin() + static_cast<long>(runs / 2), values.end());
  return values[runs / 2];
}

// The published settings: 30 dimensions, N = 50, T = 1000, G0 = 100, alpha = 20.
constexpr GsaSettings published{.masses = 50, .iterations = 1000};

TEST_CASE("Gravity finds the bottom of a sphere") {
  // Rashedi et al. 2009, F1 in [-100, 100]^30: of the order of 1e-10.
  const double median = median_of_runs(in_cube(30, 100.0, sphere), published, 5);
  CHECK(median < 1e-9);
}

TEST_CASE("Gravity ends near the lowest pits of the Rastrigin function") {
  // Rashedi et al. 2009, F9 in [-5.12, 5.12]^30: about 15. A point uniform in the box has a mean
  // of 30 (5.12^2 / 3 + 10) = 562.
  const double median = median_of_runs(in_cube(30, 5.12, rastrigin), published, 5);
  CHECK(median > 5.0);
  CHECK(median < 40.0);
}

TEST_CASE("The same seed gives the same search, another seed another") {
  const GsaProblem problem = in_cube(5, 5.12, rastrigin);
  const GsaResult once = gsa_minimum(problem, {.masses = 20, .iterations = 50, .seed = 7});
  const GsaResult again = gsa_minimum(problem, {.masses = 20, .iterations = 50, .seed = 7});
  const GsaResult other = gsa_minimum(problem, {.masses = 20, .iterations = 50, .seed = 8});
  CHECK(once.best == again.best);
  CHECK(once.history == again.history);
  CHECK(once.history != other.history);
}

TEST_CASE("One iteration of two masses goes as by hand") {
  // f(x) = x^2 from x = 1 and x = 4. Fitness 1 and 16, so m = 1 and 0, M = 1 and 0. The mass at 1
  // feels no pull. The mass at 4 feels rand G0 * 1 * (1 - 4) / 3 = -rand G0, and starts at rest:
  // with G0 = 2 it moves to 4 - 2 rand. Draws in order: one pull on mass 1 (by mass 2), one on
  // mass 2, then one for each old velocity.
  std::vector<double> seen;
  GsaProblem problem = in_cube(1, 10.0, [&](std::span<const double> x) {
    seen.push_back(x[0]);
    return x[0] * x[0];
  });
  problem.starts = {{1.0}, {4.0}};
  const GsaResult result =
      gsa_minimum(problem, {.masses = 2, .iterations = 1, .g0 = 2.0, .seed = 3});

  Random random{3};
  random.uniform();
  const double pull_on_second = random.uniform();
  REQUIRE(seen.size() == 4);
  CHECK(seen[0] == 1.0);
  CHECK(seen[1] == 4.0);
  CHECK(seen[2] == 1.0);
  CHECK(seen[3] == Approx(4.0 - 2.0 * pull_on_second));
  CHECK(result.evaluations == 4);
  CHECK(result.history.size() == 2);
}

TEST_CASE("Equally good masses weigh the same") {
  // f = 0 at 1 and 5: M = 1/2 each, so both are pulled towards the other by at most G0 / 2 = 1.
  std::vector<double> seen;
  GsaProblem problem = in_cube(1, 10.0, [&](std::span<const double> x) {
    seen.push_back(x[0]);
    return 0.0;
  });
  problem.starts = {{1.0}, {5.0}};
  gsa_minimum(problem, {.masses = 2, .iterations = 1, .g0 = 2.0});
  REQUIRE(seen.size() == 4);
  CHECK((seen[2] > 1.0 && seen[2] <= 2.0));
  CHECK((seen[3] < 5.0 && seen[3] >= 4.0));
}

TEST_CASE("A mass stops at the wall of the box") {
  // Enough gravity to throw every mass far out: G0 is a hundred times the width.
  bool inside = true;
  const GsaProblem problem = in_cube(3, 1.0, [&](std::span<const double> x) {
    for (const double v : x) inside = inside && std::abs(v) <= 1.0;
    return sphere(x);
  });
  gsa_minimum(problem, {.masses = 10, .iterations = 50, .g0 = 200.0});
  CHECK(inside);
}

TEST_CASE("Points are repaired before they are judged") {
  GsaProblem problem = in_cube(2, 8.0, sphere);
  problem.repair = [](std::span<double> x) {
    for (double& v : x) v = std::round(v);
  };
  problem.starts = {{3.4, -2.6}};
  const GsaResult result = gsa_minimum(problem, {.masses = 1, .iterations = 0});
  CHECK(result.best == std::vector<double>{3.0, -3.0});
  CHECK(result.value == 18.0);
}

TEST_CASE("The history never rises and ends at the best value") {
  const GsaResult result =
      gsa_minimum(in_cube(4, 5.12, rastrigin), {.masses = 15, .iterations = 80, .seed = 1});
  CHECK(std::is_sorted(result.history.rbegin(), result.history.rend()));
  CHECK(result.history.back() == result.value);
  CHECK(rastrigin(result.best) == result.value);
}

}  // namespace
}  // namespace furrow::planner
