#include "exchange/local_frame.hpp"

#include "tests/exchange/ground.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace furrow;
using namespace furrow::exchange;

TEST_CASE("A place goes to WGS84 and back to the micrometre, anywhere on the globe") {
  for (const Datum datum : {Datum{0, 0}, Datum{51.78, 4.26}, Datum{-16.8, 180},
                            Datum{-16.8, -179.999}, Datum{-6.41, -35.07}, Datum{80, 20}}) {
    const LocalFrame frame{datum};
    REQUIRE(frame.datum() == datum);
    for (const FieldPoint p : {at_m(0, 0), at_m(350, -20), at_m(-5000, 5000)}) {
      const GeoPoint globe = frame.to_wgs84(p);
      CHECK(std::abs(globe.lon_deg) <= 180);
      CHECK(distance(frame.to_field(globe), p).base() < 1e-6);
    }
  }
}

TEST_CASE("North of the datum is north: metres along the meridian of the ellipsoid") {
  const LocalFrame frame{{.lat_deg = 51.78, .lon_deg = 4.26}};
  const GeoPoint north = frame.to_wgs84(at_m(0, 100));
  CHECK(north.lon_deg == Approx(4.26).epsilon(1e-12));
  const double lat_deg = 51.78 + 100 / ground::meridian_radius_m(51.78) / ground::degree;
  CHECK(north.lat_deg == Approx(lat_deg).epsilon(1e-10));
}

}  // namespace
