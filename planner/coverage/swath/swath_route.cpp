#include "planner/coverage/swath/swath_route.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

FieldPoint between(FieldPoint a, FieldPoint b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

}  // namespace

Route swath_route(const SwathCoverage& coverage, Length cell) {
  require(cell > Length{}, "a cell is longer than 0");
  Route route{.cell = {}, .centers = {}, .strips = {}, .missed = {}};
  for (const SwathStrip& strip : coverage.strips) {
    const double cells = std::max(1.0, std::round((distance(strip.from, strip.to) / cell).base()));
    const auto count = static_cast<std::uint32_t>(cells);
    const auto first = static_cast<std::uint32_t>(route.centers.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      route.centers.push_back(between(strip.from, strip.to, (i + 0.5) / cells));
    }
    route.strips.push_back({.cells = {first, count},
                            .from = route.centers[first],
                            .to = route.centers.back(),
                            .continues = false,
                            .approach = strip.approach});
  }
  route.cell = (1.0 / static_cast<double>(route.centers.size())) * coverage.sprayed;
  return route;
}

}  // namespace furrow::planner
