#include "planner/fleet/queue_clock.hpp"
#include "planner/fleet/cut_plan.hpp"
#include "planner/fleet/till_empty.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner::fleet {
namespace {

/// Sixty rows of 100 m with a station each ten of them and three aircraft at each station.
FleetProblem six_stations(Random& random) {
  std::vector<StraightStrip> strips;
  for (int row = 0; row < 60; ++row) {
    const double y_m = 10.0 * row;
    strips.push_back({at_m(0, y_m), at_m(100, y_m)});
    if (row % 2 == 1) std::swap(strips.back().begin, strips.back().end);
  }
  FleetProblem p{StripPath{strips}, {}, {}};
  for (int d = 0; d < 6; ++d) {
    const FieldPoint at = at_m(-10, 100.0 * d + 50);
    p.depots.push_back({at, 1 + static_cast<std::uint32_t>(d % 2), 20, 10});
    for (int i = 0; i < 3; ++i) {
      p.fliers.push_back({.tank_m = random.uniform(100, 200),
                          .spray_mps = 5,
                          .ferry_mps = 8,
                          .until_s = i == 0 ? 300 : std::numeric_limits<double>::infinity(),
                          .start = at});
    }
  }
  return p;
}

bool is_same(const Finish& a, const Finish& b) {
  return a.makespan_s == b.makespan_s && a.total_s == b.total_s && a.wait_s == b.wait_s &&
         a.late_s == b.late_s && a.is_carried == b.is_carried;
}

TEST_CASE("a plan compared with one kept is flown as if alone, by fewer flights") {
  Random random{1};
  const FleetProblem p = six_stations(random);
  CutPlan kept{p, *till_empty(p)};
  QueueClock clock{p};
  clock.finish(kept.sorties());
  clock.keep();
  std::size_t flown = 0, all = 0;
  for (int i = 0; i < 3000; ++i) {
    CutPlan next = kept;
    if (!next.change(random)) continue;
    REQUIRE(is_same(clock.finish(next.sorties()), QueueClock{p}.finish(next.sorties())));
    flown += clock.flown();
    all += next.sorties().size();
    if (random.below(3) != 0) continue;
    clock.keep();
    kept = std::move(next);
  }
  CHECK(flown < all);
}

TEST_CASE("a plan that is the one kept needs no flight") {
  Random random{2};
  const FleetProblem p = six_stations(random);
  const FleetSorties plan = *till_empty(p);
  QueueClock clock{p};
  const Finish first = clock.finish(plan);
  CHECK(clock.flown() == plan.size());
  clock.keep();
  CHECK(is_same(clock.finish(plan), first));
  CHECK(clock.flown() == 0);
}

TEST_CASE("a pack is swapped where it does not last for the next flight") {
  // A row of 300 m away from the station, sprayed in three flights of 100 m at 5 m/s, ferried at
  // 10 m/s: 20 + 10 s, then 10 + 20 + 20 s and 20 + 20 + 30 s, 10 s in the bay, 40 s for a pack.
  // Before the last the pack has given 80 s and has to last for 70 s more.
  FleetProblem p{StripPath{{{at_m(0, 0), at_m(300, 0)}}},
                 {{.tank_m = 100, .spray_mps = 5, .ferry_mps = 10, .start = at_m(0, 0)}},
                 {{.position = at_m(0, 0), .service_s = 10, .swap_s = 40}}};
  const FleetSorties plan{{0, 100, 0, 0}, {100, 200, 0, 0}, {200, 300, 0, 0}};
  const auto makespan_s = [&](double pack_s) {
    p.fliers.front().pack_s = pack_s;
    return QueueClock{p}.finish(plan).makespan_s;
  };
  CHECK(makespan_s(150.1) == 30.0 + 10.0 + 50.0 + 10.0 + 70.0);
  CHECK(makespan_s(149.9) == 30.0 + 10.0 + 50.0 + 40.0 + 70.0);
}

TEST_CASE("services begin when a depot is open, and those that end later are told") {
  // A row of 200 m in two sorties of 20 s, from its begin and back to it: 100 m out, 100 m home,
  // 100 m out again, at 5 m/s. Home at 40 s, served 100..130 from the opening on, sprayed at 130 +
  // 20 + 20 = 170, home at 210. An end at 120 is 10 s too early.
  FleetProblem p{StripPath{std::vector<StraightStrip>{{at_m(0, 0), at_m(200, 0)}}}, {}, {}};
  p.depots.push_back({at_m(0, 0), 1, 30, 0});
  p.fliers.push_back({.tank_m = 100, .spray_mps = 5, .ferry_mps = 5, .start = at_m(0, 0)});
  const FleetSorties sorties{{0, 100, 0, 0}, {100, 200, 0, 0}};
  CHECK(QueueClock{p}.finish(sorties).total_s == Approx(40 + 30 + 80));
  p.depots[0].opens_s = 100;
  const Finish waits = QueueClock{p}.finish(sorties);
  CHECK(waits.total_s == Approx(100 + 30 + 80));
  CHECK(waits.wait_s == Approx(60));
  CHECK(waits.late_s == 0);
  p.depots[0].closes_s = 120;
  const Finish late = QueueClock{p}.finish(sorties);
  CHECK(late.late_s == Approx(10));
  CHECK(is_better(waits, late));
}

}  // namespace
}  // namespace furrow::planner::fleet
