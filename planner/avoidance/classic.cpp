#include "planner/avoidance/classic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow::planner {
namespace {

struct HalfCircle {
  double low_m, high_m, side;
  double radius_m() const { return (high_m - low_m) / 2; }
};

// Over the line at the foot of the circle's centre, which lies `beside_m` towards the side passed.
double radius_over(double beside_m, double radius_m) {
  if (beside_m >= 0) return beside_m + radius_m;
  return std::sqrt(std::max(0.0, radius_m * radius_m - beside_m * beside_m));
}

}  // namespace

PathM classic_path(const PassM& pass, const std::vector<TargetM>& targets, ClassicSide rule) {
  const RowFrame frame = RowFrame::along(pass.b - pass.a);
  std::vector<HalfCircle> halves;
  for (const TargetM& target : targets) {
    for (const CircleM& c : target.circles) {
      const PointM at = frame.to(c.center - pass.a);
      const double side = rule == ClassicSide::left || at.y <= 0 ? 1 : -1;
      const double radius_m = radius_over(side * at.y, c.radius_m);
      if (radius_m <= 0) continue;
      halves.push_back({at.x - radius_m, at.x + radius_m, side});
    }
  }
  std::stable_sort(halves.begin(), halves.end(),
                   [](const HalfCircle& a, const HalfCircle& b) { return a.low_m < b.low_m; });
  PathM path{{0, 0}};
  for (std::size_t i = 0; i < halves.size(); ++i) {
    HalfCircle h = halves[i];
    while (i + 1 < halves.size() && halves[i + 1].low_m < h.high_m) {
      h.high_m = std::max(h.high_m, halves[++i].high_m);
    }
    constexpr int legs = 60;
    const double middle_m = (h.low_m + h.high_m) / 2;
    for (int k = 0; k <= legs; ++k) {
      const double angle = std::numbers::pi * k / legs;
      path.push_back(
          {middle_m - h.radius_m() * std::cos(angle), h.side * h.radius_m() * std::sin(angle)});
    }
  }
  path.push_back({pass.length_m(), 0});
  for (PointM& p : path) p = pass.a + frame.from(p);
  return path;
}

}  // namespace furrow::planner
