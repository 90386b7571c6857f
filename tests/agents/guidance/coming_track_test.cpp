#include "agents/guidance/coming_track.hpp"

#include "agents/aircraft.hpp"
#include "agents/control_clock.hpp"
#include "tests/agents/scripted_fleet.hpp"

#include <catch2/catch.hpp>

namespace furrow::agents {
namespace {

Path bent_path() {
  Path path{{0, 0}, {.acceleration_mps2 = 2.85, .corner_cut_m = 1.0, .min_radius_m = 0.0}};
  path.add({60, 0}, 6.0);
  path.add({60, 40}, 3.0);
  path.finish();
  return path;
}

TEST_CASE("coming_track: in still air an aircraft is where it says, bends and ramps included",
          "[agents]") {
  Aircraft aircraft{settings_of(sprayer())};
  aircraft.take_off();
  const Path path = bent_path();
  aircraft.follow(path);
  const auto track =
      coming_track({aircraft.pilot().pace(), 0.0, mission_start}, path, {}, {}, no_stop);
  REQUIRE(track.size() > 4);
  CHECK(track.size() < 30);  // of 60 half seconds; straight and even stretches are thinned
  CHECK(norm(xy_m(track.back().position) - Xy{60, 40}) < 0.1);
  Instant now = mission_start;
  double furthest_m = 0.0;
  for (const TimedPlace& place : track) {
    for (; now < place.at; now += control_period) aircraft.fly(no_stop);
    furthest_m = std::max(furthest_m, norm(aircraft.truth_m() - xy_m(place.position)));
  }
  CHECK(furthest_m < 0.5);
}

TEST_CASE("coming_track: heights are climbed to no faster than the rule says", "[agents]") {
  // 6 m/s along x for 60 m; at once to 9 m: 1.2 x 3 m/s takes 2.5 s.
  HeightProfile heights;
  heights.mark(0.0, 9.0);
  const Path path = bent_path();
  const auto track = coming_track({Pace{2.85}, 0.0, mission_start}, path, heights, {}, 40.0);
  const auto climbed = std::find_if(track.begin(), track.end(),
                                    [](const TimedPlace& p) { return p.altitude_m > 8.9; });
  REQUIRE(climbed != track.end());
  CHECK(seconds(climbed->at).base() == Approx(2.5).margin(0.01));
}

TEST_CASE("mark_hop: a way climbs to its layer and comes down, or turns over below it",
          "[agents]") {
  // Up 1 m in 2 m, down 1 m in 3 m: 10 m are reached after 20 m and left 30 m before the end.
  HeightProfile high;
  high.mark_hop(0, 100, 0, 10, 0.5, 1.0 / 3);
  CHECK(high.altitude_m(10) == Approx(5));
  CHECK(high.altitude_m(20) == Approx(10));
  CHECK(high.altitude_m(70) == Approx(10));
  CHECK(high.altitude_m(85) == Approx(5));
  CHECK(high.altitude_m(100) == Approx(0));
  // 10 m long: up for 4 m, down for 6 m.
  HeightProfile low;
  low.mark_hop(0, 10, 0, 10, 0.5, 1.0 / 3);
  CHECK(low.altitude_m(4) == Approx(2));
  CHECK(low.altitude_m(7) == Approx(1));
  // From 6 m, 12 m before its end: it cannot come down so fast, and goes straight there.
  HeightProfile steep;
  steep.mark_hop(0, 12, 6, 10, 0.5, 1.0 / 3);
  CHECK(steep.altitude_m(6) == Approx(3));
}

}  // namespace
}  // namespace furrow::agents
