#include "planner/terrain/contour_flight.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

// Shares of the way from a to b at which it crosses lines `step` apart.
void add_crossings(double a, double b, double step, std::vector<double>& shares) {
  if (a == b) return;
  const double low = std::min(a, b), high = std::max(a, b);
  for (double line = std::floor(low / step) + 1; line * step < high; ++line) {
    shares.push_back((line * step - a) / (b - a));
  }
}

std::vector<double> shares_of(const Surface& surface, FieldPoint from, FieldPoint to) {
  const Raster& r = surface.raster();
  const FieldVector a = from - r.south_west, b = to - r.south_west;
  std::vector<double> shares{0, 1};
  add_crossings(a.x.base(), b.x.base(), r.step.base(), shares);
  add_crossings(a.y.base(), b.y.base(), r.step.base(), shares);
  std::sort(shares.begin(), shares.end());
  const std::size_t crossings = shares.size();
  for (std::size_t i = 1; i < crossings; ++i) shares.push_back((shares[i - 1] + shares[i]) / 2);
  std::sort(shares.begin(), shares.end());
  const auto is_same = [](double p, double q) { return q - p < 1e-12; };
  shares.erase(std::unique(shares.begin(), shares.end(), is_same), shares.end());
  shares.back() = 1;
  return shares;
}

}  // namespace

ContourFlight contour_flight(const Surface& surface, FieldPoint from, FieldPoint to,
                             const ContourRule& rule) {
  const Length length = distance(from, to);
  require(length > Length{}, "a strip has a length");
  ContourFlight flight{};
  for (const double t : shares_of(surface, from, to)) {
    const FieldPoint p = from + FieldVector{t * (to.x - from.x), t * (to.y - from.y)};
    flight.points.push_back(
        {.along = t * length, .altitude = surface.height(p) + rule.height, .speed = {}});
  }
  for (std::size_t i = 0; i + 1 < flight.points.size(); ++i) {
    ContourPoint& here = flight.points[i];
    const Length run = flight.points[i + 1].along - here.along;
    const Length rise = flight.points[i + 1].altitude - here.altitude;
    here.speed = rule.spray_speed;
    if (rise != Length{}) {
      const double slope = std::abs(rise / run);
      here.speed =
          std::min(here.speed, (1 / slope) * (rise > Length{} ? rule.climb : rule.descent));
    }
    if (here.speed < rule.slowest) {
      here.speed = rule.slowest;
      flight.too_steep += run;
    }
    flight.duration += run / here.speed;
  }
  return flight;
}

}  // namespace furrow::planner
