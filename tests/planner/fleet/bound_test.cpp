#include "planner/fleet/bound.hpp"
#include "planner/fleet/bay_bound.hpp"
#include "planner/fleet/kinds_bound.hpp"
#include "planner/fleet/work_bound.hpp"
#include "tests/planner/fleet/enumerated.hpp"
#include "tests/planner/fleet/yardsticks.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner::fleet {
namespace {

/// Two strips of 50 m along x, to and fro, 2 m apart. A station at the origin with one bay.
FleetProblem there_and_back(std::uint32_t fliers, double service_s) {
  FleetProblem p{StripPath{{{at_m(0, 0), at_m(50, 0)}, {at_m(50, 2), at_m(0, 2)}}},
                 {},
                 {{at_m(0, 0), 1, service_s}}};
  p.fliers.assign(fliers, {.tank_m = 60, .spray_mps = 1, .ferry_mps = 1, .start = at_m(0, 0)});
  return p;
}

TEST_CASE("one aircraft's best plan attains the bound of its work") {
  // A cut at 40 m, the nearest that both tanks allow: 80 m there and back, 100 m of spraying, a
  // hop of 2 m, the way home of 2 m, 7 s of service.
  const FleetProblem p = there_and_back(1, 7);
  CHECK(QueueClock{p}.finish(FleetSorties{{0, 40, 0, 0}, {40, 100, 0, 0}}).makespan_s ==
        Approx(191));
  CHECK(work_bound_s(p, 0.01) == Approx(191).margin(0.03));
  CHECK(work_bound_s(p, 0.01) <= 191);
}

TEST_CASE("first sorties take no service, and what more are worth is paid for") {
  // 184 m as above, by two that both start full.
  CHECK(work_bound_s(there_and_back(2, 7), 0.01) == Approx(184 / 2.0).margin(0.02));
  // Three aircraft need not make three sorties: a second cut would be flown to.
  CHECK(work_bound_s(there_and_back(3, 7), 0.01) == Approx(184 / 3.0).margin(0.02));
}

TEST_CASE("faster aircraft take more of the work") {
  FleetProblem p = there_and_back(2, 0);
  p.fliers[1].spray_mps = p.fliers[1].ferry_mps = 3;
  CHECK(work_bound_s(p, 0.01) == Approx(184 / 4.0).margin(0.02));
}

TEST_CASE("fills follow one another on a bay") {
  // Two tanks for the path, one of them filled: 500 s, at a station on the path.
  const LowerBound bound = bay_count_bound(there_and_back(1, 500));
  CHECK(bound.makespan_s == 500);
  CHECK(bay_count_bound(there_and_back(2, 500)).makespan_s == 0);
}

TEST_CASE("somebody flies to the farthest point and home") {
  FleetProblem p = there_and_back(50, 0);
  for (Flier& f : p.fliers) f.ferry_mps = 4;
  const LowerBound bound = best_bound(p);
  // sqrt(50^2 + 2^2) = 50.04 m there and back at 4 m/s.
  CHECK(bound.makespan_s == Approx(25.02).margin(0.01));
  CHECK(bound.name == "farthest point");
}

TEST_CASE("no plan of a small case is faster than a bound") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const FleetProblem p = enumerated::random_problem(seed);
    const double best_s = enumerated::best_makespan_s(p, enumerated::cuts_apart_m(p, 5));
    CHECK(best_bound(p).makespan_s <= best_s + 1e-9);
  }
}

TEST_CASE("no plan of a small case sprays or fills faster than a bound") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    FleetProblem p = enumerated::random_problem(seed);
    p.ends_sprayed = true;
    p.depots.front().fill_s = 10.0 * static_cast<double>(seed % 3);
    const double best_s = enumerated::best_makespan_s(p, enumerated::cuts_apart_m(p, 5));
    const double sprayed_s = best_bound(p).makespan_s;
    CHECK(sprayed_s > 0.0);
    CHECK(sprayed_s <= best_s + 1e-9);
    p.ends_sprayed = false;
    CHECK(sprayed_s <= best_bound(p).makespan_s);
  }
}

TEST_CASE("work is bounded by what each kind of aircraft can do") {
  // One tank of 100 m and one of 10 m, 200 m of path from (0, 0) along x, 1 m/s, 30 s of service.
  // If both were as good as the first, the work would be 200 m and one service at 100 m, 200 m of
  // ways and 200 m home: each half of it. But 10 m at a time cost 30 s each and the ways there, so
  // the second does little: more than the half is left to the first.
  FleetProblem p{StripPath{{{at_m(0, 0), at_m(200, 0)}}}, {}, {{at_m(0, 0), 2, 30.0}}};
  p.fliers.assign(2, {.tank_m = 100, .spray_mps = 1, .ferry_mps = 1, .start = at_m(0, 0)});
  const double alike_s = kinds_bound_s(p, 0.1);
  CHECK(alike_s == Approx(work_bound_s(p, 0.1)).margin(35));
  p.fliers[1].tank_m = 10;
  CHECK(kinds_bound_s(p, 0.1) > 1.1 * work_bound_s(p, 0.1));
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    FleetProblem small = enumerated::random_problem(seed);
    small.depots.front().fill_s = 10.0 * static_cast<double>(seed % 3);
    const double best_s = enumerated::best_makespan_s(small, enumerated::cuts_apart_m(small, 5));
    CHECK(kinds_bound_s(small, 0.1) <= best_s + 1e-9);
    CHECK(bay_bound_s(small, 0.3 * best_s, {60, 150, 240, 50}) <= best_s + 1e-9);
  }
}

TEST_CASE("aircraft that fly for a part of the time only do a part of the work") {
  const FleetProblem free = there_and_back(2, 7);
  const double free_s = kinds_bound_s(free, 0.1);
  // One of two until a quarter of that: the other does the rest, 1.75 of its half.
  FleetProblem ends = free;
  ends.fliers[1].until_s = 0.25 * free_s;
  CHECK(kinds_bound_s(ends, 0.1) == Approx(1.75 * free_s).margin(0.01));
  // One of two from then on: until then the other has done a quarter, and both share the rest.
  FleetProblem begins = free;
  begins.fliers[1].ready_s = 0.25 * free_s;
  CHECK(kinds_bound_s(begins, 0.1) == Approx(1.125 * free_s).margin(0.01));
}

TEST_CASE("what the first tanks do not carry is filled in") {
  // Tanks of 50 m for 100 m of path: half of it is filled in, with 500 s of service and 60 s of
  // filling.
  FleetProblem p = there_and_back(1, 500);
  p.fliers.resize(1);
  p.fliers[0].tank_m = 50;
  p.depots[0].fill_s = 60;
  p.depots[0].service_s = 5000;
  p.fliers[0].service_s = 0;
  CHECK(best_bound(p).makespan_s >= 5060);
}

TEST_CASE("fleets of field A are bounded as published or better") {
  for (const yardsticks::Yardstick& y : yardsticks::all) {
    CAPTURE(y.service_s, y.bays, y.fliers);
    const LowerBound bound = best_bound(yardsticks::problem(y));
    CHECK(bound.makespan_s <= y.to_beat_s);
    // The cells give away less than a metre a cut, of at most 20 cuts by four: 1 s.
    CHECK(bound.makespan_s >= y.bound_s - 2.0);
    // Ten aircraft at one bay: held up by it more than by their work.
    if (y.fliers == 10 && y.bays == 1) CHECK(bound.name == "bays");
  }
}

}  // namespace
}  // namespace furrow::planner::fleet
