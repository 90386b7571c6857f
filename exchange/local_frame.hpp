#pragma once
// The field frame on the globe.

#include "core/geometry.hpp"

#include <memory>

namespace furrow::exchange {

/// A place on the WGS84 ellipsoid.
struct GeoPoint {
  double lon_deg;  ///< East, -180 to 180.
  double lat_deg;  ///< North, -90 to 90.
};

/// Where the origin of a field frame lies.
struct Datum {
  double lat_deg, lon_deg;
  friend constexpr bool operator==(const Datum&, const Datum&) = default;
};

/// The field frame of one datum: transverse Mercator on WGS84 with the datum as its centre and
/// scale 1 there, so lengths agree with the ground to 1.3e-4 within 100 km, areas to 2.5e-4.
///
/// Works across the equator and both meridians. One thread at a time.
class LocalFrame {
 public:
  /// @pre latitude within 85 degrees of the equator, longitude finite
  explicit LocalFrame(Datum datum);
  LocalFrame(LocalFrame&&) noexcept;
  LocalFrame& operator=(LocalFrame&&) noexcept;
  ~LocalFrame();

  Datum datum() const;
  /// @pre the point is within 1000 km of the datum
  GeoPoint to_wgs84(FieldPoint point) const;
  /// @pre the point is within 1000 km of the datum
  FieldPoint to_field(GeoPoint point) const;

 private:
  struct Transforms;
  std::unique_ptr<Transforms> transforms_;
};

}  // namespace furrow::exchange
