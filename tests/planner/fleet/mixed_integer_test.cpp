#include "tests/planner/fleet/mixed_integer.hpp"
#include "planner/fleet/bound.hpp"
#include "planner/fleet/solve.hpp"
#include "tests/planner/fleet/enumerated.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace furrow::planner::fleet {
namespace {

/// One station with one bay, two aircraft at most.
FleetProblem small_case(std::uint64_t seed) {
  FleetProblem p = enumerated::random_problem(seed);
  p.depots.resize(1);
  p.depots[0].bays = 1;
  if (p.fliers.size() > 2) p.fliers.resize(2);
  return p;
}

/// The solution's cuts and the thirds of the path: the oracle is free in all else.
std::vector<double> cuts_m(const FleetProblem& p, const FleetSolution& solution) {
  std::vector<double> cuts_m = enumerated::cuts_apart_m(p, 3);
  for (const Sortie& s : solution.sorties) {
    if (s.to_m == p.path.length_m()) continue;
    const auto is_near = [&](double cut_m) { return std::abs(cut_m - s.to_m) < 0.01; };
    cuts_m.erase(std::remove_if(cuts_m.begin(), cuts_m.end(), is_near), cuts_m.end());
    cuts_m.push_back(s.to_m);
  }
  std::sort(cuts_m.begin(), cuts_m.end());
  return cuts_m;
}

TEST_CASE("the mixed-integer optimum lies between the bound and the solved plan's own cuts") {
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    const FleetProblem p = small_case(seed);
    const auto solution = solved(p, {.budget = 100'000, .seed = seed});
    REQUIRE(solution);
    const double oracle_s =
        mixed_integer_makespan_s(p, cuts_m(p, *solution), p.fliers.size() == 1 ? 4 : 3);
    CHECK(best_bound(p).makespan_s <= oracle_s + 1e-6);
    CHECK(solution->finish.makespan_s <= oracle_s + 1e-3);
    worst = std::max(worst, solution->finish.makespan_s / oracle_s - 1.0);
  }
  CAPTURE(worst);
  CHECK(worst < 1e-5);  // of what GLPK takes for whole
}

}  // namespace
}  // namespace furrow::planner::fleet
