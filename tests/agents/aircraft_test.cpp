#include "agents/aircraft.hpp"

#include "agents/conduct/sortie_route.hpp"
#include "agents/control_clock.hpp"
#include "tests/agents/scripted_fleet.hpp"

#include "agents/guidance/height_profile.hpp"

#include <catch2/catch.hpp>

namespace furrow::agents {
namespace {

struct Flown {
  double time_s = 0.0, planned_s = 0.0, spray_m = 0.0;
  double top_mps = 0.0, top_mps2 = 0.0;  // over ground
  double cross_rms_m = 0.0, cross_most_m = 0.0, end_m = 0.0;
};

// Four strips of 700 m and home, without anyone to ask.
Flown four_strips(const Vehicle& v, const Wind& wind) {
  Aircraft aircraft{settings_of(v, wind)};
  const SortieRoute route = sortie_route({0, 0}, strips(4, 350), {0, 0}, v, {}, Surroundings{});
  aircraft.take_off();
  aircraft.follow(route.path);
  Flown flown{.planned_s = route.path.duration_s(), .spray_m = route.spray_m};
  Xy before{};
  double squares = 0.0, samples = 0.0;
  do {
    aircraft.fly(no_stop);
    flown.time_s += control_period_s;
    flown.top_mps = std::max(flown.top_mps, norm(aircraft.velocity_mps()));
    flown.top_mps2 =
        std::max(flown.top_mps2, norm(aircraft.velocity_mps() - before) / control_period_s);
    before = aircraft.velocity_mps();
    const Segment& s = aircraft.pilot().segment();
    const double along = aircraft.along_m();
    if (s.is_straight() && along > route.pieces[0].from_m && along < route.pieces[3].close_m) {
      const double cross = deviation(s, aircraft.truth_m()).cross_m;
      squares += cross * cross;
      flown.cross_most_m = std::max(flown.cross_most_m, std::abs(cross));
      ++samples;
    }
  } while (!aircraft.is_at_rest(no_stop) && flown.time_s < 3000.0);
  flown.cross_rms_m = std::sqrt(squares / samples);
  flown.end_m = norm(aircraft.truth_m());
  return flown;
}

Vehicle with(Gnss gnss) {
  Vehicle v = sprayer();
  v.gnss = gnss;
  return v;
}

const Wind gusty{.mean = metres_per_second(6), .from_deg = 250, .gust = metres_per_second(1.5)};

TEST_CASE("aircraft: takes within 1 % of the constant-speed time in still air", "[agents]") {
  const Flown flown = four_strips(sprayer(), {});
  // 4 * 698 m of strips and 3 moves of 2 m at 3 m/s; from the depot to (1, 1) and back from (7, 1)
  // at 6 m/s.
  const double constant_speed_s =
      (4 * 698.0 + 3 * 2.0) / 3.0 + (std::sqrt(2.0) + std::sqrt(50.0)) / 6.0;
  INFO("flown " << flown.time_s << " s, constant speed " << constant_speed_s << " s");
  CHECK(flown.time_s == Approx(constant_speed_s).epsilon(0.01));
  CHECK(flown.time_s == Approx(flown.planned_s).margin(3.0));
}

TEST_CASE("aircraft: keeps its limits of speed and acceleration in still air", "[agents]") {
  const Flown flown = four_strips(sprayer(), {});
  CHECK(flown.top_mps <= 6.0 * 1.02);  // measured velocity is off by 0.05 m/s
  CHECK(flown.top_mps2 <= 3.0 + 1e-9);
  CHECK(flown.end_m < 0.5);
}

TEST_CASE("aircraft: RTK keeps within 0.15 m of the strips in a wind of 6 m/s", "[agents]") {
  const Flown flown = four_strips(with({.sigma = metres(0.02), .bias = {}}), gusty);
  INFO("RMS " << flown.cross_rms_m << " m, most " << flown.cross_most_m << " m");
  CHECK(flown.cross_rms_m < 0.15);
  CHECK(flown.cross_most_m < 0.5);
  CHECK(flown.time_s == Approx(flown.planned_s).epsilon(0.01));
}

TEST_CASE("aircraft: a standalone receiver's bias is not flown away, its noise is", "[agents]") {
  const Flown unbiased = four_strips(with({.sigma = metres(1.5), .bias = {}}), gusty);
  INFO("RMS " << unbiased.cross_rms_m << " m");
  CHECK(unbiased.cross_rms_m < 0.3);
  const Flown biased = four_strips(with({.sigma = metres(1.5), .bias = metres(1.5)}), gusty);
  INFO("biased RMS " << biased.cross_rms_m << " m");
  CHECK(biased.cross_rms_m < 1.5 + 0.3);
}

TEST_CASE("aircraft: a steady wind leaves no offset", "[agents]") {
  const Wind steady{.mean = metres_per_second(6), .from_deg = 270, .gust = {}};
  CHECK(four_strips(sprayer(), steady).cross_rms_m < 0.05);
}

TEST_CASE("aircraft: blown away by a storm it waits for itself and does not diverge", "[agents]") {
  Aircraft aircraft{
      settings_of(sprayer(), {.mean = metres_per_second(40), .from_deg = 0, .gust = {}})};
  Path path{{0, 0}, {.acceleration_mps2 = 2.8, .corner_cut_m = 1.0, .min_radius_m = 0.0}};
  path.add({0, 500}, 6.0);
  path.finish();
  aircraft.take_off();
  aircraft.follow(path);
  for (int i = 0; i < 600; ++i) aircraft.fly(no_stop);
  CHECK(aircraft.pilot().pace().along_m() < 20.0);  // did not run on without the aircraft
  CHECK_FALSE(aircraft.is_at_rest(no_stop));
}

TEST_CASE("heights: a profile is straight between its marks and counts what rises", "[agents]") {
  HeightProfile heights;
  CHECK(heights.is_level());
  CHECK(heights.altitude_m(7) == 0);
  for (const auto& [along_m, altitude_m] : {std::pair{0.0, 3.0}, {10.0, 8.0}, {30.0, 4.0}}) {
    heights.mark(along_m, altitude_m);
  }
  CHECK(heights.altitude_m(-1) == 3);
  CHECK(heights.altitude_m(4) == Approx(5));
  CHECK(heights.altitude_m(20) == Approx(6));
  CHECK(heights.altitude_m(31) == 4);
  CHECK(heights.climb_m() == Approx(5));
}

}  // namespace
}  // namespace furrow::agents
