#include "agents/vehicle/stores.hpp"

#include "agents/vehicle/airframe.hpp"
#include "tests/agents/scripted_fleet.hpp"

#include <catch2/catch.hpp>

namespace furrow::agents {
namespace {

TEST_CASE("stores: what is used beyond them stays as a debt", "[agents]") {
  Stores stores;
  stores.spray(sprayer(), 2970.0);  // a tank lasts 900 s at 3 m/s, 2700 m
  CHECK(stores.tank_share == Approx(-0.1));
  stores.fly(sprayer(), 1650.0);  // of 1500 s
  CHECK(stores.pack_share == Approx(-0.1));
}

TEST_CASE("airframe: makes its ferry speed until the head wind takes all thrust", "[agents]") {
  // 3 m/s2 and twice 6 m/s of drag at 0.25 1/s: 24 m/s through the air.
  CHECK(headway_mps(sprayer(), 0.0) == 6.0);
  CHECK(headway_mps(sprayer(), -10.0) == 6.0);
  CHECK(headway_mps(sprayer(), 18.0) == Approx(6.0));
  CHECK(headway_mps(sprayer(), 20.0) == Approx(4.0));
  CHECK(headway_mps(sprayer(), 30.0) < 0.0);
}

}  // namespace
}  // namespace furrow::agents
