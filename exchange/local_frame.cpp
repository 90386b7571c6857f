#include "exchange/local_frame.hpp"

#include "core/require.hpp"
#include "exchange/gdal.hpp"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <cmath>

namespace furrow::exchange {

namespace {

using Transform = std::unique_ptr<OGRCoordinateTransformation>;

Transform transform(const OGRSpatialReference& from, const OGRSpatialReference& to) {
  return Transform{OGRCreateCoordinateTransformation(&from, &to)};
}

OGRSpatialReference transverse_mercator(Datum datum) {
  OGRSpatialReference frame;
  frame.importFromProj4(fmt::format("+proj=tmerc +lat_0={:.12f} +lon_0={:.12f} +k=1 +x_0=0 +y_0=0 "
                                    "+datum=WGS84 +units=m +no_defs",
                                    datum.lat_deg, datum.lon_deg)
                            .c_str());
  frame.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return frame;
}

}  // namespace

struct LocalFrame::Transforms {
  Datum datum;
  Transform to_globe, to_plane;
};

LocalFrame::LocalFrame(Datum datum) {
  require(std::abs(datum.lat_deg) <= 85 && std::isfinite(datum.lon_deg),
          "a datum lies within 85 degrees of the equator");
  const GdalScope quiet;
  const OGRSpatialReference plane = transverse_mercator(datum);
  const OGRSpatialReference globe = wgs84();
  transforms_ = std::make_unique<Transforms>(
      Transforms{datum, transform(plane, globe), transform(globe, plane)});
  require(transforms_->to_globe && transforms_->to_plane, "PROJ knows the transverse Mercator");
}

LocalFrame::LocalFrame(LocalFrame&&) noexcept = default;
LocalFrame& LocalFrame::operator=(LocalFrame&&) noexcept = default;
LocalFrame::~LocalFrame() = default;

Datum LocalFrame::datum() const { return transforms_->datum; }

GeoPoint LocalFrame::to_wgs84(FieldPoint point) const {
  const GdalScope quiet;
  double x = point.x.base(), y = point.y.base();
  require(transforms_->to_globe->Transform(1, &x, &y), "a point lies near its datum");
  return {std::remainder(x, 360.0), y};
}

FieldPoint LocalFrame::to_field(GeoPoint point) const {
  const GdalScope quiet;
  double x = point.lon_deg, y = point.lat_deg;
  require(transforms_->to_plane->Transform(1, &x, &y), "a point lies near its datum");
  return at_m(x, y);
}

}  // namespace furrow::exchange
