#include "exchange/formats/formats.hpp"
#include "exchange/gdal.hpp"

#include <cctype>
#include <string_view>

namespace furrow::exchange {

namespace {

// "SRID=25832;" in front of a geometry, taken off `rest`: the code, or 0 where there is none.
int taken_srid(std::string_view& rest) {
  constexpr std::string_view mark = "SRID=";
  if (!rest.starts_with(mark)) return 0;
  const auto end = rest.find(';');
  if (end == std::string_view::npos) return -1;
  const auto code = number(rest.substr(mark.size(), end - mark.size()));
  rest.remove_prefix(end + 1);
  const bool is_code = code && *code >= 1 && *code <= 999'999 && *code == static_cast<int>(*code);
  return is_code ? static_cast<int>(*code) : -1;
}

void skip_gap(std::string_view& rest) {
  while (!rest.empty() && (std::isspace(static_cast<unsigned char>(rest.front())) ||
                           rest.front() == ';' || rest.front() == '\0')) {
    rest.remove_prefix(1);
  }
}

}  // namespace

std::optional<Fault> read_well_known_text(const LandFile& file, Polygons& found) {
  const GdalScope gdal;
  std::string_view rest = file.bytes;
  for (skip_gap(rest); !rest.empty(); skip_gap(rest)) {
    const std::string_view here = rest;
    OGRSpatialReference crs;
    const int srid = taken_srid(rest);
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (srid < 0 || (srid > 0 && crs.importFromEPSG(srid) != OGRERR_NONE)) {
      return Fault{"SRID must be a known EPSG code", shown(here)};
    }
    const char* next = rest.data();  // std::string ends in a zero, where GDAL stops at the latest
    OGRGeometry* geometry = nullptr;
    const OGRErr fault = OGRGeometryFactory::createFromWkt(&next, nullptr, &geometry);
    const std::unique_ptr<OGRGeometry> owned{geometry};
    if (fault != OGRERR_NONE || !owned || next <= rest.data()) {
      return Fault{"must be a sound WKT geometry", shown(here)};
    }
    found.add(*owned, {.crs = srid > 0 ? &crs : nullptr});
    rest.remove_prefix(std::min(rest.size(), static_cast<std::size_t>(next - rest.data())));
  }
  return std::nullopt;
}

}  // namespace furrow::exchange
