#include "mission/place.hpp"

#include <fmt/format.h>

namespace furrow::mission {

std::string place(FieldPoint p, const std::optional<exchange::Datum>& datum) {
  std::string text = fmt::format("({:.7g}, {:.7g}) m", p.x.base(), p.y.base());
  if (!datum) return text;
  const exchange::GeoPoint on = exchange::LocalFrame{*datum}.to_wgs84(p);
  return text + fmt::format(", lat {:.7f}, lon {:.7f}", on.lat_deg, on.lon_deg);
}

}  // namespace furrow::mission
