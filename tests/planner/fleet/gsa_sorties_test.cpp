#include "planner/fleet/gsa_sorties.hpp"
#include "planner/fleet/queue_clock.hpp"
#include "planner/fleet/till_empty.hpp"
#include "tests/planner/fleet/enumerated.hpp"
#include "tests/planner/fleet/yardsticks.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner::fleet {
namespace {

TEST_CASE("gravity on shares is never later than till empty or simple") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    CAPTURE(seed);
    const FleetProblem p = enumerated::random_problem(seed);
    QueueClock clock{p};
    const auto sorties = gsa_sorties(p, {.masses = 10, .iterations = 20, .seed = seed});
    REQUIRE(sorties);
    const double makespan_s = clock.finish(*sorties).makespan_s;
    CHECK(makespan_s <= clock.finish(*till_empty(p)).makespan_s);
    CHECK(makespan_s <= clock.finish(*simple_sorties(p)).makespan_s);
  }
}

TEST_CASE("gravity on shares is faster than till empty on field A where bays leave room") {
  for (const yardsticks::Yardstick& y : yardsticks::all) {
    const FleetProblem p = yardsticks::problem(y);
    const auto sorties = gsa_sorties(p);
    REQUIRE(sorties);
    CHECK(QueueClock{p}.finish(*sorties).makespan_s <= y.till_empty_s + 0.6);
  }
}

}  // namespace
}  // namespace furrow::planner::fleet
