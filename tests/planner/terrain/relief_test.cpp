#include "planner/terrain/relief.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace furrow::planner {
namespace {

// A ramp that rises 1 m in `run_m` eastwards from x = 0 on.
Surface ramp(double run_m) {
  Raster raster{at_m(0, 0), metres(10), 101, 2, {}};
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i <= 100; ++i) raster.heights_m.push_back(static_cast<float>(10 * i / run_m));
  }
  return Surface{raster};
}

const HeightRule rule{.spray_height = metres(3),
                      .clearance = metres(15),
                      .climb = metres_per_second(3),
                      .descent = metres_per_second(2),
                      .climb_energy_s_per_m = 0.1,
                      .layers = 3,
                      .layer = metres(5)};

TEST_CASE("Work keeps its height and slows down where the ground outpaces climb or descent") {
  const Relief relief{ramp(2), rule, {}};
  const AirWay up = relief.contour(at_m(0, 5), at_m(100, 5), metres_per_second(8));
  CHECK(up.altitude_m == Approx(3));
  for (const AirLeg& leg : up.legs) {
    CHECK(leg.altitude_m == Approx(3 + leg.to.x.base() / 2));
    CHECK(leg.limit_mps == Approx(6));  // rises 0.5 m per metre: 3 m/s of climb
  }
  // 50 m of climb: 100 / 6 s, and 5 s more of the pack.
  CHECK(relief.cost(at_m(0, 5), up).time_s == Approx(100 / 6.0));
  CHECK(relief.cost(at_m(0, 5), up).energy_s == Approx(100 / 6.0 + 5));
  CHECK(relief.too_steep_m(at_m(0, 5), up) == 0);

  const AirWay down = relief.contour(at_m(100, 5), at_m(0, 5), metres_per_second(8));
  CHECK(down.legs.front().limit_mps == Approx(4));
  CHECK(relief.cost(at_m(100, 5), down).energy_s == Approx(25));
}

TEST_CASE("Where even the least speed is too fast the length is said") {
  const Relief relief{ramp(0.5), rule, {}};  // 2 m per metre: 1.5 m/s, a quarter of 8 is 2
  const AirWay up = relief.contour(at_m(0, 5), at_m(40, 5), metres_per_second(8));
  CHECK(up.legs.front().limit_mps == Approx(2));
  CHECK(relief.too_steep_m(at_m(0, 5), up) == Approx(40));
}

TEST_CASE("A ferry climbs out and comes down at full speed and keeps its layer between") {
  const Relief relief{Surface::level(metres(100)), rule, {}};
  const std::vector<FieldPoint> way{at_m(0, 0), at_m(400, 0)};
  for (const AgentId agent : {AgentId{1}, AgentId{2}, AgentId{3}, AgentId{4}}) {
    const Length layer = relief.layer_of(agent);
    CHECK(layer == metres(5.0 * ((number(agent) - 1) % 3)));
    const AirWay air = relief.ferry(way, metres_per_second(6), layer);
    CHECK(air.altitude_m == Approx(103));
    CHECK(air.legs.back().altitude_m == Approx(103));
    double highest_m = 0;
    for (const AirLeg& leg : air.legs) {
      CHECK(leg.limit_mps == Approx(6));
      highest_m = std::max(highest_m, leg.altitude_m);
    }
    CHECK(highest_m == Approx(115 + layer.base()));
    const FlightCost cost = relief.cost(at_m(0, 0), air);
    CHECK(cost.time_s == Approx(400 / 6.0));
    CHECK(cost.energy_s == Approx(400 / 6.0 + 0.1 * (12 + layer.base())));
  }
}

TEST_CASE("A ferry that begins in the air comes down to its layer or goes on climbing") {
  const Relief relief{Surface::level(metres(100)), rule, {}};
  const std::vector<FieldPoint> way{at_m(0, 0), at_m(400, 0)};
  const auto altitude_m = [&](double begins_m, double x_m) {
    const AirWay air = relief.ferry(way, metres_per_second(6), {}, metres(begins_m));
    double last_m = air.altitude_m;
    for (const AirLeg& leg : air.legs) {
      if (leg.to.x.base() <= x_m + 1e-6) last_m = leg.altitude_m;
    }
    return last_m;
  };
  CHECK(altitude_m(110, 0) == Approx(110));
  CHECK(altitude_m(110, 20) == Approx(115));  // 3 m/s up at 6 m/s: 10 m more, but 115 m is kept
  CHECK(altitude_m(125, 0) == Approx(125));
  CHECK(altitude_m(125, 200) == Approx(115));
  CHECK(altitude_m(90, 0) == Approx(103));
}

TEST_CASE("No ferry is under work height where the ground is steeper than it climbs or descends") {
  // From 34 m of ground 60 m before the top to as much behind it: at 63 m over the top it is 26 m
  // above its end, and 60 m at a third descend 20 m.
  const AnalyticTerrain hill{.base = {},
                             .peaks = {{at_m(200, 0), metres(60), metres(80), metres(80)}}};
  const Relief relief{{.ground = hill, .rule = rule}, {at_m(-50, -200), at_m(450, 200)}};
  const std::vector<FieldPoint> way{at_m(140, 0), at_m(260, 0)};
  const AirWay air = relief.ferry(way, metres_per_second(6), {});
  for (const AirLeg& leg : air.legs) {
    CHECK(leg.altitude_m >= height(hill, leg.to).base() + 3 - 0.11);
  }
  CHECK(relief.cost(way.front(), air).time_s > 120 / 6.0);
}

TEST_CASE("A ferry in plan keeps its clearance but near its ends, and climbs in time") {
  const AnalyticTerrain hill{.base = {},
                             .peaks = {{at_m(300, 0), metres(40), metres(80), metres(80)}}};
  const Relief relief{{.ground = hill, .rule = rule}, {at_m(-50, -200), at_m(650, 200)}};
  const std::vector<FieldPoint> way{at_m(0, 0), at_m(300, 0), at_m(600, 0)};
  const AirWay air = relief.ferry(way, metres_per_second(6), metres(5));
  // 3 m/s up and 2 m/s down at 6 m/s: a half and a third of a metre per metre.
  double before_m = air.altitude_m, before_x = 0;
  int bends = 0;
  for (const AirLeg& leg : air.legs) {
    const double x = leg.to.x.base(), ground_m = height(hill, leg.to).base();
    const double kept_m = std::min({20.0, 3 + x / 2, 3 + (600 - x) / 3});
    CHECK(leg.altitude_m >= ground_m + kept_m - 1e-3 * x);
    CHECK(leg.altitude_m - before_m <= (x - before_x) / 2 + 1e-6);
    CHECK(before_m - leg.altitude_m <= (x - before_x) / 3 + 1e-6);
    CHECK(leg.limit_mps == Approx(6));
    CHECK(leg.altitude_m <= relief.highest_ferry_m() + 1e-6);
    bends += leg.bends;
    before_m = leg.altitude_m;
    before_x = x;
  }
  CHECK(bends == 2);
  CHECK(before_m == Approx(relief.work_altitude_m(way.back())));
}

}  // namespace
}  // namespace furrow::planner
