#include "agents/guidance/height_profile.hpp"

#include <algorithm>

namespace furrow::agents {

double HeightProfile::altitude_m(double along_m) const {
  if (marks_.empty()) return 0.0;
  const auto next = std::partition_point(marks_.begin(), marks_.end(),
                                         [along_m](const Mark& m) { return m.along_m <= along_m; });
  if (next == marks_.begin()) return marks_.front().altitude_m;
  if (next == marks_.end()) return marks_.back().altitude_m;
  const Mark &a = *(next - 1), &b = *next;
  const double share = (along_m - a.along_m) / (b.along_m - a.along_m);
  return a.altitude_m + share * (b.altitude_m - a.altitude_m);
}

void HeightProfile::mark_hop(double from_m, double to_m, double begins_m, double layer_m, double up,
                             double down) {
  const double length_m = to_m - from_m;
  mark(from_m, begins_m);
  const double meets_m = std::max(0.0, (down * length_m - begins_m) / (up + down));
  const double top_m = std::min(std::max(layer_m, begins_m), begins_m + up * meets_m);
  if (top_m > begins_m) mark(from_m + (top_m - begins_m) / up, top_m);
  if (length_m > top_m / down) mark(to_m - top_m / down, top_m);
  mark(to_m, 0.0);
}

double HeightProfile::climb_m() const {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < marks_.size(); ++i) {
    sum_m += std::max(0.0, marks_[i].altitude_m - marks_[i - 1].altitude_m);
  }
  return sum_m;
}

}  // namespace furrow::agents
