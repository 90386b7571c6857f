#include "scheduler/lower_bound.hpp"

#include "planner/returns/evaluate.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

// The earliest finish of a share over all stations and all return points, batteries included.
double best_finish_s(const planner::Route& route, CellRange cells, const Vehicle& v,
                     const std::vector<Station>& stations) {
  double best_s = 1e9;
  for (const Station& s : stations) {
    const auto problem = planner::return_problem(route, cells, v, s);
    for (std::uint32_t mask = 0; mask < 1u << (cells.count - 1); ++mask) {
      planner::Returns returns;
      for (std::uint32_t c = 0; c + 1 < cells.count; ++c) {
        if (mask >> c & 1u) returns.push_back(c);
      }
      const auto plan = planner::evaluated(problem, returns);
      if (!planner::is_feasible(problem, plan)) continue;
      best_s = std::min(best_s, problem.fly_out_m / v.ferry_speed.base() +
                                    problem.on_route_s.back() + plan.non_spray_s);
    }
  }
  return best_s;
}

// Two aircraft, every cut, either order of aircraft.
double best_makespan_s(const planner::Route& route, const std::vector<Vehicle>& vehicles,
                       const std::vector<Station>& stations) {
  const auto all = static_cast<std::uint32_t>(route.centers.size());
  double best_s = 1e9;
  for (const std::size_t a : {0u, 1u}) {
    for (const planner::Strip& strip : route.strips) {
      const std::uint32_t cut = end(strip.cells);
      double latest_s = best_finish_s(route, {0, cut}, vehicles[a], stations);
      if (cut < all) {
        latest_s =
            std::max(latest_s, best_finish_s(route, {cut, all - cut}, vehicles[1 - a], stations));
      }
      best_s = std::min(best_s, latest_s);
    }
  }
  return best_s;
}

TEST_CASE("lower_bound: no plan of a small field beats it, and it is close", "[scheduler]") {
  const planner::Route route = comb(3, 4);
  const std::vector stations{station(1, 1, at_m(-2, 0)), station(2, 1, at_m(6, 9))};
  std::vector vehicles{vehicle(1), vehicle(2)};
  for (Vehicle& v : vehicles) {
    v.spray_endurance = metres(8) / v.spray_speed;
    v.flight_endurance = seconds(9.0);
  }
  const double best_s = best_makespan_s(route, vehicles, stations);
  const double bound_s =
      makespan_bound_s(route, route_lengths(route, stations), vehicles, stations);
  CHECK(bound_s <= best_s);
  CHECK(bound_s >= 0.6 * best_s);
}

TEST_CASE("lower_bound: holds for unlike aircraft", "[scheduler]") {
  const planner::Route route = comb(4, 3);
  const std::vector stations{station(1, 1, at_m(3, -5))};
  std::vector vehicles{vehicle(1), vehicle(2)};
  vehicles[0].spray_endurance = metres(6) / vehicles[0].spray_speed;
  vehicles[1].spray_speed = metres_per_second(1);
  vehicles[1].spray_endurance = metres(12) / vehicles[1].spray_speed;
  vehicles[1].home = at_m(8, 8);
  CHECK(makespan_bound_s(route, route_lengths(route, stations), vehicles, stations) <=
        best_makespan_s(route, vehicles, stations));
}

TEST_CASE("lower_bound: two slow aircraft beside a fast one are not counted as fast",
          "[scheduler]") {
  const planner::Route route = comb(60, 50);
  const std::vector stations{station(1)};
  std::vector vehicles{vehicle(1), vehicle(2), vehicle(3)};
  vehicles[1].spray_speed = vehicles[2].spray_speed = metres_per_second(0.3);
  // 60 strips of 98 m, 59 moves of 2 m, less two at the cuts: 5994 m at 3.6 m/s take 1665 s.
  CHECK(makespan_bound_s(route, route_lengths(route, stations), vehicles, stations) >= 1664.9);
}

}  // namespace
}  // namespace furrow::scheduler
