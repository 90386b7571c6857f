#include "planner/search/r_algorithm.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace furrow::planner {
namespace {

TEST_CASE("the r-algorithm climbs along a narrow ridge") {
  // -|x - 1| - 100 |x + y - 3|: greatest, 0, at (1, 2).
  const auto ridge = [](std::span<const double> x, std::span<double> slope) {
    const double along = x[0] - 1, across = x[0] + x[1] - 3;
    slope[1] = across > 0 ? -100 : 100;
    slope[0] = slope[1] + (along > 0 ? -1 : 1);
    return -std::abs(along) - 100 * std::abs(across);
  };
  const RResult top = r_algorithm(ridge, {-7, 5}, {.evaluations = 300});
  CHECK(top.value > -1e-3);
  CHECK(top.best[0] == Approx(1).margin(1e-2));
  CHECK(top.best[1] == Approx(2).margin(1e-2));
  CHECK(top.evaluations <= 300);
}

TEST_CASE("the r-algorithm stays where there is no slope") {
  const auto flat = [](std::span<const double>, std::span<double> slope) {
    slope[0] = 0;
    return 4.0;
  };
  CHECK(r_algorithm(flat, {2}, {.evaluations = 10}).evaluations == 1);
}

}  // namespace
}  // namespace furrow::planner
