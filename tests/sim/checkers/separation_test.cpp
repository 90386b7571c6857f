#include "sim/checkers/separation.hpp"
#include "tests/sim/checkers/scripted_log.hpp"

#include <catch2/catch.hpp>

namespace furrow::sim {
namespace {

TrackPoint point(double at_s, double x_m, double y_m, double altitude_m = 0.0) {
  return {.at = instant(seconds(at_s)),
          .position = at_m(x_m, y_m),
          .spraying = false,
          .altitude_m = altitude_m};
}

double s(Instant at) { return seconds(at).base(); }

TEST_CASE("separation: two that cross are near for as long as they are, with their least distance",
          "[sim]") {
  // At right angles, both at 5 m/s, the second 1 s behind at the crossing (10, 0). From there their
  // difference is (5 t - 10, 15 - 5 t) m: least at t = 2.5 s, (2.5, 2.5) m apart, 3.5355 m; under
  // 5 m where 25 ((t - 2)^2 + (3 - t)^2) < 25, so from 2 s to 3 s.
  std::vector<AirTrack> tracks(2);
  for (int t = 0; t <= 5; ++t) {
    tracks[0].points.push_back(point(t, 5.0 * t, 0));
    tracks[1].points.push_back(point(t, 10, 5.0 * t - 15));
  }
  const Separation near = separation(tracks, 5.0);
  REQUIRE(near.encounters.size() == 1);
  const Encounter& e = near.encounters[0];
  CHECK(e.first == 0);
  CHECK(e.second == 1);
  CHECK(s(e.from) == Approx(2.0));
  CHECK(s(e.to) == Approx(3.0));
  CHECK(e.closest_m == Approx(3.5355).epsilon(1e-4));
  CHECK(near.closest_m == e.closest_m);
  CHECK(separation(tracks, 3.5).encounters.empty());
  CHECK_FALSE(separation(tracks, 3.5).closest_m);
}

TEST_CASE("separation: a long stretch beside each other is one encounter, a second one another",
          "[sim]") {
  std::vector<AirTrack> tracks(2);
  for (int t = 0; t <= 20; ++t) {
    tracks[0].points.push_back(point(t, 3.0 * t, 0));
    const double beside_m = t >= 8 && t <= 12 ? 50 : 1;
    tracks[1].points.push_back(point(t, 3.0 * t, beside_m));
  }
  const Separation near = separation(tracks, 2.0);
  REQUIRE(near.encounters.size() == 2);
  CHECK(s(near.encounters[0].from) == Approx(0.0));
  CHECK(s(near.encounters[1].to) == Approx(20.0));
  CHECK(near.encounters[0].closest_m == Approx(1.0));
}

TEST_CASE("separation: on the ground, and in layers far enough apart, nobody is near", "[sim]") {
  // The first stands at the station from 4.5 s to 5.5 s, where the second passes at 5 s.
  AirTrack stops{{point(3.5, -3, 0), point(4.5, 0, 0), point(5.5, 0, 0), point(6.5, 3, 0)},
                 {at(4.5)}};
  AirTrack passing, hovering, above;
  for (int t = 0; t <= 10; ++t) passing.points.push_back(point(t, 0, 5.0 * (t - 5)));
  CHECK(separation({stops, passing}, 2.0).encounters.empty());
  stops.landings.clear();  // it hovers there
  CHECK(separation({stops, passing}, 2.0).encounters.size() == 1);

  for (int t = 0; t <= 10; ++t) {
    hovering.points.push_back(point(t, 0, 0, 10));
    above.points.push_back(point(t, 0.1 * t - 0.5, 0, 14));
  }
  CHECK(separation({hovering, above}, 4.0).encounters.empty());
  CHECK(separation({hovering, above}, 4.1).closest_m == Approx(4.0));
}

TEST_CASE("separation: points between whole seconds are flown straight, too", "[sim]") {
  // The second dashes in to 1 m and out again within one second.
  const AirTrack still{{point(0, 0, 0), point(1, 0, 0), point(2, 0, 0)}, {}};
  const AirTrack dash{
      {point(0, 9, 0), point(1, 9, 0), point(1.4, 1, 0), point(1.8, 9, 0), point(2, 9, 0)}, {}};
  const Separation near = separation({still, dash}, 3.0);
  REQUIRE(near.encounters.size() == 1);
  CHECK(near.encounters[0].closest_m == Approx(1.0));
  // 20 m/s on both legs: 2 m before and after the turn.
  CHECK(s(near.encounters[0].from) == Approx(1.3));
  CHECK(s(near.encounters[0].to) == Approx(1.5));
}

TEST_CASE("laws: L24 two aircraft that come too near are told, with when and how near", "[sim]") {
  // Side by side 0.8 m apart from the first second to the third.
  const auto flown = [](AgentId agent, double y_m) {
    FlightRecord record{};
    record.agent = agent;
    for (int t = 1; t <= 3; ++t) record.track.push_back(point(t, 5.0 * t, y_m));
    return record;
  };
  Facts f = facts();
  f.whole = false;
  Script script;
  script.say(node(one), 4, flown(one, 0));
  script.say(node(two), 4, flown(two, 0.8));
  const auto broken = [&](std::optional<Length> separation) {
    f.separation = separation;
    std::vector<std::string> told;
    for (const Violation& v : violations(f, script.log, at(5))) {
      if (v.law == "L24") told.push_back(v.detail);
    }
    return told;
  };
  CHECK(broken(metres(1)) ==
        std::vector<std::string>{"UAVs 1 and 2 were 0.80 m from each other, less than 1.00 m"});
  CHECK(broken(metres(0.5)).empty());
  CHECK(broken(std::nullopt).empty());
}

}  // namespace
}  // namespace furrow::sim
