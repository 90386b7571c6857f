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
    // No sortie but the last ends after the first cell.
    for (std::uint32_t mask = 0; mask < 1u << (cells.count - 1); mask += 2) {
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

// Every order of aircraft and every cut; aircraft may get nothing.
double best_makespan_s(const planner::Route& route, const std::vector<Vehicle>& vehicles,
                       const std::vector<Station>& stations, std::size_t first_strip = 0) {
  if (first_strip == route.strips.size()) return 0.0;
  double best_s = 1e9;
  for (std::size_t v = 0; v < vehicles.size(); ++v) {
    std::vector<Vehicle> others = vehicles;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(v));
    const std::uint32_t first = route.strips[first_strip].cells.first;
    for (std::size_t s = first_strip; s < route.strips.size(); ++s) {
      const CellRange cells{first, end(route.strips[s].cells) - first};
      const double own_s = best_finish_s(route, cells, vehicles[v], stations);
      best_s = std::min(best_s, std::max(own_s, best_makespan_s(route, others, stations, s + 1)));
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

TEST_CASE("lower_bound: three unlike aircraft in any order, from close below", "[scheduler]") {
  const planner::Route route = comb(5, 2);
  const std::vector stations{station(1, 1, at_m(3, -5))};
  std::vector vehicles{vehicle(1), vehicle(2), vehicle(3)};
  for (Vehicle& v : vehicles) v.spray_endurance = metres(12) / v.spray_speed;
  vehicles[0].spray_speed = metres_per_second(0.5);
  vehicles[0].spray_endurance = metres(4) / vehicles[0].spray_speed;
  vehicles[2].home = at_m(9, -5);
  const double best_s = best_makespan_s(route, vehicles, stations);
  const double bound_s =
      makespan_bound_s(route, route_lengths(route, stations), vehicles, stations);
  CHECK(bound_s <= best_s);
  CHECK(bound_s >= 0.9 * best_s);
}

TEST_CASE("lower_bound: fleets of more kinds than can be told apart still have one",
          "[scheduler]") {
  const planner::Route route = comb(40, 5);
  const std::vector stations{station(1)};
  std::vector<Vehicle> vehicles;
  for (std::uint32_t i = 1; i <= 20; ++i) {
    vehicles.push_back(vehicle(i));
    vehicles.back().spray_speed = metres_per_second(1.0 + 0.1 * i);
  }
  const double bound_s =
      makespan_bound_s(route, route_lengths(route, stations), vehicles, stations);
  // 40 strips of 8 m and 39 moves of 2 m, less 19 at the cuts, by 20 at 3 m/s: 6 s. Two strips
  // each take the slowest 18 m at 1.1 m/s, and 80 m at 6 m/s to get there at most: 30 s.
  CHECK(bound_s >= 6.0);
  CHECK(bound_s <= 30.0);
}

TEST_CASE("lower_bound: what one bay has to fill takes its time", "[scheduler]") {
  const planner::Route route = comb(10, 10);
  const std::vector stations{station(1)};
  std::vector vehicles(5, vehicle(1));
  for (Vehicle& v : vehicles) v.spray_endurance = metres(20) / v.spray_speed;
  // 10 strips of 18 m and 9 moves of 2 m, less 4 at the cuts, are 190 m; less five tanks of 20 m,
  // 90 m. Five fills of 20 s, and 40 s for each 20 m: 280 s.
  CHECK(makespan_bound_s(route, route_lengths(route, stations), vehicles, stations) ==
        Approx(280.0));
}

}  // namespace
}  // namespace furrow::scheduler
