#include "agents/conduct/flight_log.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace furrow::agents {
namespace {

constexpr AgentId agent_3{3};

Instant tenths(int count) { return Instant{} + count * duration(seconds(0.1)); }

TEST_CASE("flight log: a straight way keeps only the points asked for", "[agents]") {
  FlightLog log{agent_3};
  log.point(tenths(0), {0, 0}, 2, false);
  for (int i = 1; i < 10; ++i) log.pass(tenths(i), {0.8 * i, 0.02 * (i % 2)}, 2, false);
  log.point(tenths(10), {8, 0}, 2, false);
  CHECK(log.take().track.size() == 2);
}

TEST_CASE("flight log: the top of a climb between points is kept", "[agents]") {
  // Up at 3 m/s to 1.5 m after half a second and down again; a line would stay at 0 m.
  FlightLog log{agent_3};
  log.point(tenths(0), {0, 0}, 0, false);
  for (int i = 1; i < 10; ++i) log.pass(tenths(i), {0.8 * i, 0}, 0.3 * std::min(i, 10 - i), false);
  log.point(tenths(10), {8, 0}, 0, false);
  const auto track = log.take().track;
  REQUIRE(track.size() == 3);
  CHECK(track[1].at == tenths(5));
  CHECK(track[1].altitude_m == Approx(1.5));
}

TEST_CASE("flight log: a bend between points is followed within 3 cm", "[agents]") {
  // A quarter of a circle of radius 5 m in one second; its chord passes 5 (1 - sqrt(1/2)) = 1.46 m
  // inside it.
  const auto place = [](int i) {
    const double angle = i * 0.157;
    return Xy{5 * std::sin(angle), 5 - 5 * std::cos(angle)};
  };
  FlightLog log{agent_3};
  log.point(tenths(0), place(0), 2, true);
  for (int i = 1; i < 10; ++i) log.pass(tenths(i), place(i), 2, true);
  log.point(tenths(10), place(10), 2, true);
  const auto track = log.take().track;
  // Chords of two tenths lie 5 (1 - cos 0.157) = 0.06 m inside, so every place is kept.
  REQUIRE(track.size() == 11);
  for (int i = 0; i <= 10; ++i) {
    CHECK(track[static_cast<std::size_t>(i)].at == tenths(i));
    CHECK(track[static_cast<std::size_t>(i)].spraying);
  }
}

}  // namespace
}  // namespace furrow::agents
