#include "agents/guidance/deviation.hpp"

namespace furrow::agents {

Deviation deviation(const Segment& s, Xy fix_m) {
  const Xy right = right_of(s.ahead);
  const Xy rel = fix_m - s.from;
  if (s.is_straight()) return {s.start_m + dot(rel, s.ahead), dot(rel, right)};

  const double k = s.curvature_per_m;
  const Xy from_center = rel - (1.0 / k) * right;
  const double angle = std::atan2(k * dot(from_center, s.ahead), -k * dot(from_center, right));
  const double outside = norm(from_center) - 1.0 / std::abs(k);
  return {s.start_m + angle / k, k > 0.0 ? -outside : outside};
}

double cross_track_m(Xy from_m, Xy to_m, Xy point_m) {
  const double length = norm(to_m - from_m);
  if (length == 0.0) return 0.0;
  return dot(point_m - from_m, right_of((1.0 / length) * (to_m - from_m)));
}

}  // namespace furrow::agents
