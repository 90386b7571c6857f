#include "scheduler/partition.hpp"

#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

#include <functional>

namespace furrow::scheduler {
namespace {

struct Fleet {
  planner::Route route;
  std::vector<Station> stations;
  std::vector<Vehicle> vehicles;
  RouteLengths lengths = route_lengths(route, stations);
  std::vector<std::vector<Pace>> paces{};

  PartitionProblem problem() {
    paces.clear();
    FirstFlights flights{route};
    for (const Vehicle& v : vehicles) {
      auto& row = paces.emplace_back();
      for (std::size_t s = 0; s < stations.size(); ++s) {
        row.push_back(pace(flights, v, stations[s], lengths.home_m[s]));
      }
    }
    return {route, lengths, paces, std::vector(vehicles.size(), 1.0)};
  }
};

Vehicle quick(std::uint32_t id, double spray_mps, double tank_m) {
  Vehicle v = vehicle(id);
  v.spray_speed = metres_per_second(spray_mps);
  v.ferry_speed = metres_per_second(2 * spray_mps);
  v.spray_endurance = metres(tank_m) / v.spray_speed;
  return v;
}

double share_s(const PartitionProblem& p, std::size_t uav, std::uint32_t first,
               std::uint32_t count) {
  double best_s = count == 0 ? 0.0 : 1e9;
  for (const Pace& pace : p.paces[uav]) {
    GrowingShare share{p.route, p.lengths, pace, first};
    double finish_s = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) finish_s = share.grow();
    best_s = std::min(best_s, p.stretch[uav] * finish_s);
  }
  return best_s;
}

// The smallest latest finish over every way to cut the strips from `first` on among the aircraft
// from `uav` on.
double brute_force_s(const PartitionProblem& p, std::size_t uav, std::uint32_t first) {
  const auto strips = static_cast<std::uint32_t>(p.route.strips.size());
  if (uav + 1 == p.paces.size()) return share_s(p, uav, first, strips - first);
  double best_s = 1e9;
  for (std::uint32_t count = 0; first + count <= strips; ++count) {
    best_s = std::min(
        best_s, std::max(share_s(p, uav, first, count), brute_force_s(p, uav + 1, first + count)));
  }
  return best_s;
}

double latest_s(const std::vector<Share>& shares) {
  double latest = 0.0;
  for (const Share& s : shares) latest = std::max(latest, s.finish_s);
  return latest;
}

TEST_CASE("partition: as good as the best of all cuts, for unlike aircraft and two stations",
          "[scheduler]") {
  Fleet fleet{comb(11, 40),
              {station(1), station(2, 1, at_m(22, 80))},
              {quick(1, 3, 200), quick(2, 5, 120), quick(3, 2, 300)}};
  PartitionProblem p = fleet.problem();
  CHECK(latest_s(partition(p)) <= brute_force_s(p, 0, 0) + 0.05);
  p.stretch = {1.0, 1.3, 0.9};
  CHECK(latest_s(partition(p)) <= brute_force_s(p, 0, 0) + 0.05);
}

TEST_CASE("partition: shares are contiguous, in the order of the aircraft, and leave nothing out",
          "[scheduler]") {
  Fleet fleet{comb(25, 60), {station(1)}, {quick(1, 3, 500), quick(2, 6, 500), quick(3, 3, 500)}};
  const auto shares = partition(fleet.problem());
  std::uint32_t next = 0;
  for (const Share& s : shares) {
    CHECK(s.strips.first == next);
    next = end(s.strips);
  }
  CHECK(next == 25);
  // The one that sprays and ferries twice as fast gets about twice the strips.
  CHECK(shares[1].strips.count >= 11);
}

TEST_CASE("partition: more aircraft than strips leave the rest on the ground", "[scheduler]") {
  Fleet fleet{comb(2, 30), {station(1)}, {vehicle(1), vehicle(2), vehicle(3), vehicle(4)}};
  const auto shares = partition(fleet.problem());
  REQUIRE(shares.size() == 4);
  CHECK(shares[0].strips == CellRange{0, 1});
  CHECK(shares[1].strips == CellRange{1, 1});
  CHECK(shares[2].strips.count == 0);
  CHECK(shares[3].strips.count == 0);
}

}  // namespace
}  // namespace furrow::scheduler
