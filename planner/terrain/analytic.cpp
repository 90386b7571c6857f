#include "planner/terrain/analytic.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

Length base_height(const BaseTerrain& k, FieldPoint p) {
  const double x = p.x / k.wave, y = p.y / k.wave, r = std::hypot(x, y);
  return (std::sin(y + k.a) + k.b * std::sin(x) + k.c * std::cos(k.d * r) + k.e * std::cos(y) +
          k.f * std::sin(k.g * r)) *
         k.rise;
}

Length peak_height(const std::vector<Peak>& peaks, FieldPoint p) {
  Length sum;
  for (const Peak& peak : peaks) {
    const double u = (p.x - peak.top.x) / peak.extent_x, v = (p.y - peak.top.y) / peak.extent_y;
    sum += std::exp(-u * u - v * v) * peak.height;
  }
  return sum;
}

Length base_error(const BaseTerrain& k, Length step) {
  const double h = step / k.wave;
  const double ring = std::abs(k.c) * k.d * k.d;  // bounds both second derivatives of c cos(d r)
  const double curved = std::abs(k.b) + ring + 1 + std::abs(k.e) + ring;
  const double cone = std::abs(k.f * k.g);
  return (h * h / 8 * curved + cone * h / std::sqrt(2.0)) * metres(std::abs(k.rise.base()));
}

Length peak_error(const std::vector<Peak>& peaks, Length step) {
  Length sum;
  for (const Peak& peak : peaks) {
    // |d2/dx2| of h exp(-(x / x_s)^2 ...) is largest at the top: 2 h / x_s^2.
    const double u = step / peak.extent_x, v = step / peak.extent_y;
    sum += (2 * (u * u + v * v) / 8) * metres(std::abs(peak.height.base()));
  }
  return sum;
}

}  // namespace

Length height(const AnalyticTerrain& terrain, FieldPoint p) {
  const Length peaks = peak_height(terrain.peaks, p);
  return terrain.base ? std::max(peaks, base_height(*terrain.base, p)) : peaks;
}

Length interpolation_error(const AnalyticTerrain& terrain, Length step) {
  const Length peaks = peak_error(terrain.peaks, step);
  return terrain.base ? std::max(peaks, base_error(*terrain.base, step)) : peaks;
}

}  // namespace furrow::planner
