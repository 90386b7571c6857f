#include "scheduler/forecast.hpp"

#include "core/random.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

Itinerary flight(std::uint32_t agent, std::vector<double> flights_s, std::vector<double> services_s,
                 double last_spray_s = 10) {
  const std::size_t returns = flights_s.size();
  return {.agent = AgentId{agent},
          .flights_s = std::move(flights_s),
          .services_s = std::move(services_s),
          .stations = std::vector(returns, 0U),
          .last_spray_s = last_spray_s,
          .last_home_s = 5,
          .flies = true};
}

TEST_CASE("forecast: one bay serves first come first served", "[scheduler]") {
  // 1 comes at 100, 2 at 90: 2 is served 90..150, 1 waits 50 s and is served 150..210.
  const std::vector fleet{flight(1, {100}, {60}), flight(2, {90}, {60})};
  const std::vector stations{station(1, 1)};
  const Forecast f = forecast(fleet, stations);
  CHECK(f.visits[1][0].starts_s == 90);
  CHECK(f.visits[0][0].starts_s == 150);
  CHECK(f.visits[0][0].ready_s == 210);
  CHECK(f.queue_wait_s == 50);
  CHECK(f.spray_ends_s == std::vector{220.0, 160.0});
  CHECK(f.lands_s == std::vector{225.0, 165.0});
  CHECK(f.makespan_s == 220);
}

TEST_CASE("forecast: those who come at the same instant are served by agent id", "[scheduler]") {
  const std::vector fleet{flight(1, {50}, {30}), flight(2, {50}, {30})};
  const std::vector stations{station(1, 1)};
  const Forecast f = forecast(fleet, stations);
  CHECK(f.visits[0][0].starts_s == 50);
  CHECK(f.visits[1][0].starts_s == 80);
}

TEST_CASE("forecast: two bays serve two at once, in the lowest free bay", "[scheduler]") {
  // 1 in bay 1 from 10 to 40, 2 in bay 2 from 20 to 30, 3 comes at 25 and waits for bay 2; 2 comes
  // again at 42 when both are free but bay 2 was taken till 55.
  const std::vector fleet{flight(1, {10}, {30}), flight(2, {20, 12}, {10, 30}),
                          flight(3, {25}, {25})};
  const std::vector stations{station(1, 2)};
  const Forecast f = forecast(fleet, stations);
  CHECK(f.visits[0][0].bay == 1);
  CHECK(f.visits[1][0].bay == 2);
  CHECK(f.visits[2][0].bay == 2);
  CHECK(f.visits[2][0].starts_s == 30);
  CHECK(f.visits[1][1].bay == 1);
  CHECK(f.visits[1][1].starts_s == 42);
  CHECK(f.queue_wait_s == 5);
}

TEST_CASE("forecast: stations queue apart", "[scheduler]") {
  std::vector fleet{flight(1, {50}, {30}), flight(2, {50}, {30})};
  fleet[1].stations = {1};
  const std::vector stations{station(1, 1), station(2, 1)};
  CHECK(forecast(fleet, stations).queue_wait_s == 0);
}

TEST_CASE("forecast: an aircraft that changes stations queues at each", "[scheduler]") {
  // 1 is served at the first station from 50 to 80 and comes to the second at 90, where 2 is served
  // from 60 to 100: it waits 10 s.
  std::vector fleet{flight(1, {50, 10}, {30, 30}), flight(2, {60}, {40})};
  fleet[0].stations = {0, 1};
  fleet[1].stations = {1};
  const std::vector stations{station(1, 1), station(2, 1)};
  const Forecast f = forecast(fleet, stations);
  REQUIRE(f.visits[0].size() == 2);
  CHECK(f.visits[0][1].arrives_s == 90);
  CHECK(f.visits[0][1].starts_s == 100);
  CHECK(f.queue_wait_s == 10);
  CHECK(f.spray_ends_s[0] == 140);
}

TEST_CASE("forecast: an aircraft without a share does not fly", "[scheduler]") {
  const std::vector fleet{grounded(AgentId{1})};
  const std::vector stations{station(1)};
  const Forecast f = forecast(fleet, stations);
  CHECK(f.makespan_s == 0);
  CHECK(f.lands_s[0] == 0);
}

TEST_CASE("forecast: the queue clock finds the wait that the forecast finds", "[scheduler]") {
  const Itinerary third = flight(3, {100, 100}, {60, 60}, 90);
  std::vector fleet{flight(1, {100, 100}, {60, 60}), flight(2, {90, 130}, {60, 60}),
                    flight(3, {}, {})};
  QueueClock clock{station(1, 1), fleet};
  const double others_s = clock.queue_wait_without_s(2);
  const double all_s = clock.queue_wait_s(2, third);
  const std::vector stations{station(1, 1)};
  CHECK(others_s == forecast(fleet, stations).queue_wait_s);
  fleet[2] = third;
  CHECK(all_s == forecast(fleet, stations).queue_wait_s);
  CHECK(all_s > others_s);
}

TEST_CASE("forecast: a fleet changed one by one ends as when all are flown again", "[scheduler]") {
  Random random{1};
  const std::vector stations{station(1, 1), station(2, 2)};
  const auto drawn = [&](std::uint32_t agent) {
    const std::size_t returns = random.below(4);
    Itinerary it = flight(agent, {}, {}, random.uniform(10, 50));
    it.stations.assign(returns, static_cast<std::uint32_t>(random.below(2)));
    for (std::size_t n = 0; n < returns; ++n) {
      it.flights_s.push_back(random.uniform(20, 60));
      it.services_s.push_back(random.uniform(10, 40));
    }
    return it;
  };
  std::vector<Itinerary> fleet;
  for (std::uint32_t u = 1; u <= 8; ++u) fleet.push_back(drawn(u));
  FleetEnds ends{fleet, stations};
  for (int n = 0; n < 200; ++n) {
    const std::size_t index = random.below(fleet.size());
    const Itinerary other = drawn(static_cast<std::uint32_t>(index) + 1);
    std::vector<Itinerary> changed = fleet;
    changed[index] = other;
    const Forecast again = forecast(changed, stations);
    REQUIRE(ends.with(index, other) == again.spray_ends_s);
    REQUIRE(worth(ends.with(index, other)) == worth(again));
    if (n % 2 == 0) continue;
    ends.change(index, other);
    fleet = changed;
    REQUIRE(ends.spray_ends_s() == again.spray_ends_s);
  }
}

TEST_CASE("forecast: a station serves from when it opens, and services beyond its end are too late",
          "[scheduler]") {
  // Both come before it opens at 200: 1 is served 200..260, 2 260..320. Of 400 s of which it is
  // open for 200, plans keep 8: the end is 392. With an end at 300, 4 s are kept: 320 is 24 late.
  const std::vector fleet{flight(1, {100}, {60}), flight(2, {110}, {60})};
  std::vector stations{station(1, 1)};
  stations[0].available_from = seconds(200);
  stations[0].available_until = seconds(400);
  const Forecast f = forecast(fleet, stations);
  CHECK(f.visits[0][0].starts_s == 200);
  CHECK(f.visits[1][0].starts_s == 260);
  CHECK(f.queue_wait_s == 100 + 150);
  CHECK(f.late_s == 0);
  const std::vector vehicles{vehicle(1), vehicle(2)};
  CHECK(is_in_time(vehicles, f));
  QueueClock clock{stations[0], fleet};
  CHECK(clock.queue_wait_s(1, fleet[1]) == 250);

  stations[0].available_until = seconds(300);
  const Forecast late = forecast(fleet, stations);
  CHECK(late.late_s == Approx(24));
  CHECK(late.makespan_s == f.makespan_s);
  CHECK_FALSE(is_in_time(vehicles, late));
}

}  // namespace
}  // namespace furrow::scheduler
