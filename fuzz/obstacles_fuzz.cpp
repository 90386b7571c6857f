#include "exchange/land.hpp"

#include "core/require.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace furrow;
  using namespace furrow::exchange;
  static const LocalFrame frame{{.lat_deg = 51.781, .lon_deg = 4.262}};
  const LandFile file{.path = "fuzz", .bytes = {reinterpret_cast<const char*>(data), size}};
  const auto obstacles = read_obstacles(file, frame);
  if (!obstacles) return 0;
  for (const auto& [obstacle, feature, seen_within, appears] : *obstacles) {
    require(!seen_within || *seen_within > metres(0), "it is seen from somewhere");
    require(obstacle.radius > metres(0), "an obstacle has a radius");
    require(std::isfinite(distance(at_m(0, 0), obstacle.center).base()), "it is somewhere");
  }
  return 0;
}
