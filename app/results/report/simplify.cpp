#include "app/results/report/simplify.hpp"

#include <algorithm>
#include <utility>

namespace furrow::app {
namespace {

double distance(Pixel p, Pixel a, Pixel b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double along = squared > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared : 0;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

}  // namespace

std::vector<Pixel> simplified(const std::vector<Pixel>& chain, double tolerance) {
  if (chain.size() < 3) return chain;
  std::vector<bool> kept(chain.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, chain.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t furthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distance(chain[i], chain[first], chain[last]);
      if (off > most) {
        most = off;
        furthest = i;
      }
    }
    if (furthest == first) continue;
    kept[furthest] = true;
    open.emplace_back(first, furthest);
    open.emplace_back(furthest, last);
  }
  std::vector<Pixel> left;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (kept[i]) left.push_back(chain[i]);
  }
  return left;
}

}  // namespace furrow::app
