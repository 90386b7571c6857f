// Every land reader: the format is told by the bytes, so each has a corpus of its own. Behind
// the mark stands the table of a shapefile, or the external file of an ISOXML task. A shapefile has
// degrees as its CRS.
#include "exchange/land.hpp"

#include "core/require.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

using namespace furrow;
using namespace furrow::exchange;

constexpr const char* degrees =
    R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],)"
    R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
constexpr std::string_view mark = "\n--companion--\n";

LandFile file_of(std::string_view bytes) {
  const auto at = bytes.find(mark);
  LandFile file{
      .path = "fuzz", .bytes = std::string{bytes.substr(0, at)}, .companions = {{"prj", degrees}}};
  if (at != std::string_view::npos) {
    const std::string rest{bytes.substr(at + mark.size())};
    file.companions["dbf"] = rest;
    if (file.bytes.find("<XFR") != std::string::npos) file.companions = {{"PFD00001.XML", rest}};
  }
  return file;
}

void check(const Ring& ring) {
  require(ring.size() >= 3, "a ring has 3 vertices");
  for (const FieldPoint p : ring) {
    require(std::isfinite(p.x.base()) && std::isfinite(p.y.base()), "a vertex is somewhere");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const LandFile file = file_of({reinterpret_cast<const char*>(data), size});
  for (const std::size_t feature : {0U, 1U}) {
    const auto land = read_land(file, feature);
    if (!land) {
      require(text(land.error()).find('\n') == std::string::npos, "an error is one line");
      continue;
    }
    require(feature < land->features, "a feature is one of those of the file");
    check(land->field.boundary);
    for (const Ring& hole : land->field.holes) check(hole);
  }
  return 0;
}
