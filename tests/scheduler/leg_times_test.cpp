#include "scheduler/leg_times.hpp"

#include "core/random.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace furrow::scheduler {
namespace {

// Rows with approaches, detours of short legs and corners of every kind.
std::vector<Leg> winding(std::uint64_t seed, std::size_t count) {
  Random random{seed};
  std::vector<Leg> legs;
  double heading = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_long = random.uniform() < 0.2;
    const double draw = random.uniform();
    legs.push_back({.x = std::cos(heading),
                    .y = std::sin(heading),
                    .length_m = is_long ? 20 + 80 * random.uniform() : 0.5 + 3 * random.uniform(),
                    .limit_mps = random.uniform() < 0.8 ? 3.0 : 6.0,
                    .corner = draw < 0.6    ? Corner::cut
                              : draw < 0.95 ? Corner::held
                                            : Corner::stop});
    heading += (random.uniform() < 0.2 ? std::numbers::pi : 0.6) * (random.uniform() - 0.5);
  }
  return legs;
}

std::vector<Leg> part(const std::vector<Leg>& legs, std::size_t first, std::size_t last) {
  return {legs.begin() + static_cast<std::ptrdiff_t>(first),
          legs.begin() + static_cast<std::ptrdiff_t>(last + 1)};
}

TEST_CASE("leg times: a flight that shares the middle of a way takes as long as leg by leg") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const std::vector<Leg> way = winding(seed, 120);
    const LegTimes times{vehicle(1), way};
    Random random{seed};
    const std::size_t first = 2 + static_cast<std::size_t>(50 * random.uniform());
    const std::size_t last = first + 1 + static_cast<std::size_t>(60 * random.uniform());
    // Out, along two legs of the way and what it shares, along one more, and home.
    const std::vector<Leg> out = winding(1000 + seed, 3), home = winding(2000 + seed, 4);
    std::vector<Leg> head = out, tail{way[last]};
    head.push_back(way[first - 1]);
    head.push_back(way[first]);
    tail.insert(tail.end(), home.begin(), home.end());
    std::vector<Leg> whole = out;
    const std::vector<Leg> along = part(way, first - 1, last);
    whole.insert(whole.end(), along.begin(), along.end());
    const std::size_t sprayed = whole.size();
    whole.insert(whole.end(), home.begin(), home.end());

    const SortieTimes shared = times.of(head, {first, last}, tail, 1);
    const SortieTimes alone = times.of(whole, sprayed);
    INFO("seed " << seed << ", legs " << first << " to " << last);
    CHECK(shared.until_sprayed_s == Approx(alone.until_sprayed_s).epsilon(1e-12));
    CHECK(shared.home_s == Approx(alone.home_s).margin(1e-9));
  }
}

TEST_CASE("leg times: legs of no length leave their corner to the leg before") {
  Legs legs{at_m(0, 0)};
  legs.add(at_m(0, 0), metres_per_second(3), Corner::stop);
  CHECK(legs.count() == 0);
  legs.add(at_m(0, 10), metres_per_second(3), Corner::cut);
  legs.add(at_m(0, 10), metres_per_second(6), Corner::held);
  REQUIRE(legs.count() == 1);
  CHECK(legs.all()[0].corner == Corner::held);
  CHECK(legs.all()[0].length_m == Approx(10));
  CHECK(legs.all()[0].y == Approx(1));
}

}  // namespace
}  // namespace furrow::scheduler
