#include "planner/fleet/by_station.hpp"
#include "planner/fleet/queue_clock.hpp"
#include "planner/fleet/till_empty.hpp"

#include <catch2/catch.hpp>

namespace furrow::planner::fleet {
namespace {

/// Twelve rows of 100 m along x, 10 m apart; stations at their begins, south and north, with one
/// and two aircraft.
FleetProblem south_and_north() {
  std::vector<StraightStrip> strips;
  for (int row = 0; row < 12; ++row) {
    const double y_m = 10.0 * row;
    strips.push_back({at_m(0, y_m), at_m(100, y_m)});
    if (row % 2 == 1) std::swap(strips.back().begin, strips.back().end);
  }
  FleetProblem p{StripPath{strips}, {}, {{at_m(0, 100), 1, 10}, {at_m(0, 0), 1, 10}}};
  const auto flier = [](double y_m) {
    return Flier{.tank_m = 200, .spray_mps = 1, .ferry_mps = 1, .start = at_m(0, y_m)};
  };
  p.fliers = {flier(90), flier(0), flier(110)};
  return p;
}

TEST_CASE("each station's aircraft take a stretch as long as they need to be as late as others") {
  const FleetProblem p = south_and_north();
  const std::vector<StationPart> parts = by_station(p);
  REQUIRE(parts.size() == 2);
  // The path begins in the south, at the second station.
  CHECK(parts[0].depot == 1);
  CHECK(parts[0].fliers == std::vector<std::uint32_t>{1});
  CHECK(parts[1].fliers == std::vector<std::uint32_t>{0, 2});
  CHECK(parts[0].problem.path.length_m() + parts[1].problem.path.length_m() == Approx(1200));
  CHECK(parts[1].from_m == Approx(400).margin(100));
}

TEST_CASE("the parts' plans together spray the whole path, each as if alone") {
  const FleetProblem p = south_and_north();
  const std::vector<StationPart> parts = by_station(p);
  std::vector<FleetSorties> sorties;
  double last_s = 0.0;
  for (const StationPart& part : parts) {
    sorties.push_back(*till_empty(part.problem));
    last_s = std::max(last_s, QueueClock{part.problem}.finish(sorties.back()).makespan_s);
  }
  const FleetSorties whole = of_whole(p, parts, sorties);
  CHECK(whole.size() == sorties[0].size() + sorties[1].size());
  CHECK(whole.back().to_m == 1200);
  CHECK(QueueClock{p}.finish(whole).makespan_s == Approx(last_s));
}

TEST_CASE("a part of a path has its hops and its ways") {
  const StripPath whole = south_and_north().path;
  const StripPath part = whole.part(50, 250);
  CHECK(part.strips() == 3);
  CHECK(part.length_m() == Approx(200));
  CHECK(part.hops_m(0, 200) == Approx(20));
  CHECK(part.out_m(at_m(0, 0), 0) == Approx(50));
  CHECK(part.back_m(at_m(0, 20), 200) == Approx(50));
}

}  // namespace
}  // namespace furrow::planner::fleet
