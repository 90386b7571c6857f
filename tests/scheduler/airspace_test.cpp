#include "scheduler/airspace.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

Instant at(double s) { return instant(seconds(s)); }

/// From `from` to `to` in ten seconds from `begins_s` on, at one height.
FlightClaim flight(std::uint32_t agent, FieldPoint from, FieldPoint to, double begins_s,
                   Departure departure = Departure::from_ground, double altitude_m = 0.0) {
  return {.agent = AgentId{agent},
          .boot = BootId{agent},
          .claim = 1,
          .departure = departure,
          .track = {{at(begins_s), from, altitude_m}, {at(begins_s + 10), to, altitude_m}}};
}

/// Along x at 6 m/s.
FlightClaim along(std::uint32_t agent, Departure departure = Departure::from_ground,
                  double altitude_m = 0.0) {
  return flight(agent, at_m(0, 0), at_m(60, 0), 1, departure, altitude_m);
}

/// Across it at 6 m/s, at (30, 0) when the first would be.
FlightClaim across(std::uint32_t agent, Departure departure = Departure::from_ground,
                   double altitude_m = 0.0) {
  return flight(agent, at_m(30, -30), at_m(30, 30), 1, departure, altitude_m);
}

double departs_s(const std::optional<FlightGrant>& grant) {
  REQUIRE(grant);
  REQUIRE(grant->is_clear);
  return seconds(grant->departs).base();
}

TEST_CASE("airspace: who follows on the same way is put off until the first is far enough ahead",
          "[scheduler]") {
  // Tracks keep 1 m and 1.5 m of room: 2.5 m at 6 m/s is 0.42 s, in steps of 0.5 s.
  Airspace air{metres(1)};
  CHECK(departs_s(air.answer(along(1), {}, {}, at(0))) == 1.0);
  CHECK(departs_s(air.answer(along(2), {}, {}, at(0))) == 1.5);
  CHECK(departs_s(air.answer(along(2), {}, {}, at(0.9))) == 1.5);  // said again
}

TEST_CASE("airspace: a claim that comes late begins at a period after it is heard", "[scheduler]") {
  Airspace air{metres(1)};
  CHECK(departs_s(air.answer(along(1), {}, {}, at(1.23))) == Approx(1.3));
}

TEST_CASE("airspace: ways cross at heights further apart than the distance and its room",
          "[scheduler]") {
  // In height 1 m and 0.3 m of room.
  const auto begins_s = [](double altitude_m) {
    Airspace air{metres(1)};
    air.answer(along(1), {}, {}, at(0));
    return departs_s(air.answer(across(2, Departure::from_ground, altitude_m), {}, {}, at(0)));
  };
  CHECK(begins_s(1.4) == 1.0);
  CHECK(begins_s(1.2) > 1.0);
}

TEST_CASE("airspace: a flight in motion is clear as claimed or refused", "[scheduler]") {
  Airspace air{metres(1)};
  air.answer(along(1), {}, {}, at(0));
  const auto refused = air.answer(across(2, Departure::in_motion), {}, {}, at(0));
  REQUIRE(refused);
  CHECK_FALSE(refused->is_clear);
  // What is refused is in nobody's way.
  CHECK(departs_s(air.answer(across(3, Departure::from_ground, 5), {}, {}, at(0))) == 1.0);
  FlightClaim later = flight(2, at_m(30, -30), at_m(30, 30), 3, Departure::in_motion);
  later.claim = 2;
  CHECK(departs_s(air.answer(later, {}, {}, at(2))) == 3.0);
}

TEST_CASE("airspace: who hovers until its way is clear is kept away from meanwhile",
          "[scheduler]") {
  // It hovers at (30, 0) from 5.5 s until another has left (30, 40) at 20 s, so the place is taken
  // when the next would pass it at 12 s.
  Airspace air{metres(1)};
  const WorkSite site{AgentId{9}, at_m(28, 40), at_m(32, 40), 0.0, at(0), at(20)};
  const auto hovers = flight(2, at_m(30, 0), at_m(30, 60), 5.5, Departure::from_hover);
  CHECK(departs_s(air.answer(hovers, {site}, {}, at(5))) > 19);
  CHECK(departs_s(air.answer(flight(3, at_m(0, 1), at_m(60, 1), 7), {}, {}, at(5))) > 7);
}

TEST_CASE("airspace: a flight that has begun is told clear, and others are put off for it",
          "[scheduler]") {
  Airspace air{metres(1)};
  air.answer(along(1), {}, {}, at(0));
  CHECK(departs_s(air.answer(across(2, Departure::begun), {}, {}, at(0))) == 1.0);
  CHECK(departs_s(air.answer(across(3), {}, {}, at(0))) > 1.0);
}

TEST_CASE("airspace: low ways wait until those at work have passed, high ones do not",
          "[scheduler]") {
  Airspace air{metres(1)};
  const WorkSite site{AgentId{9}, at_m(30, -5), at_m(30, 5), 0.0, at(0), at(9)};
  CHECK(departs_s(air.answer(along(1, Departure::from_ground, 2), {site}, {}, at(0))) == 1.0);
  CHECK(departs_s(air.answer(along(2), {site}, {}, at(0))) == 9.5);
  CHECK(departs_s(air.answer(along(9), {site}, {}, at(0))) < 9.5);  // its own work
}

TEST_CASE("airspace: who comes to work waits until low ways across it are flown", "[scheduler]") {
  // The first passes (30, 0) at 6 s. The second comes to (30, 30) at 3 s and from there may be
  // there from 4 s on for good: it comes no sooner than the first has gone.
  Airspace air{metres(1)};
  air.answer(along(1), {}, {}, at(0));
  FlightClaim claim = flight(2, at_m(30, 90), at_m(30, 30), -7);
  const WorkSite after{AgentId{2}, at_m(30, 5), at_m(30, -5), 0.0, at(4), never};
  CHECK(departs_s(air.answer(claim, {after}, {}, at(-8))) > -5);
  CHECK(departs_s(air.answer(flight(3, at_m(30, 90), at_m(30, 30), -7), {}, {}, at(-8))) == -7.0);
}

TEST_CASE("airspace: work near to others' work begins when they have left it", "[scheduler]") {
  // Work behind the flight is at (80, 0) from 15 s to 19 s. Another works 0.7 m beside it until 20
  // s, or later by three tenths of what is left until then: 26 s.
  Airspace air{metres(1)};
  const WorkSite own{AgentId{1}, at_m(80, 0), at_m(90, 0), 0.0, at(15), at(19)};
  const WorkSite beside{AgentId{9}, at_m(90, 0.7), at_m(80, 0.7), 0.0, at(0), at(20)};
  CHECK(departs_s(air.answer(along(1), {own, beside}, {}, at(0))) == 1.0);
  Airspace careful{metres(1)};
  CHECK(departs_s(careful.answer(along(1), {own, beside}, metres(2), at(0))) == 12.5);
  CHECK_FALSE(careful.is_clear({own}, {beside}, metres(2), at(0)));
  CHECK(careful.is_clear({own}, {beside}, metres(0.5), at(0)));
  // Told at 5 s, work is done by 19 + 0.3 x 14 = 23.2 s.
  const auto comes_at = [](double s) {
    return WorkSite{AgentId{9}, at_m(90, 0.7), at_m(80, 0.7), 0.0, at(s), never};
  };
  CHECK_FALSE(careful.is_clear({own}, {comes_at(22)}, metres(2), at(5)));
  CHECK(careful.is_clear({own}, {comes_at(24)}, metres(2), at(5)));
}

TEST_CASE("airspace: a flight that is never clear is not answered", "[scheduler]") {
  Airspace air{metres(1)};
  const WorkSite site{AgentId{9}, at_m(30, -5), at_m(30, 5), 0.0, at(0), never};
  CHECK_FALSE(air.answer(along(1), {site}, {}, at(0)));
}

}  // namespace
}  // namespace furrow::scheduler
