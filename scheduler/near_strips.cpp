#include "scheduler/near_strips.hpp"

#include "planner/coverage/plane.hpp"

#include <algorithm>
#include <cstddef>

namespace furrow::scheduler {
namespace {

using planner::PointM;

PointM plane(FieldPoint p) { return {p.x.base(), p.y.base()}; }

// In a frame along the first strip.
struct Line {
  std::size_t strip;
  PointM from, to;

  double low_m() const { return std::min(from.y, to.y); }
  double high_m() const { return std::max(from.y, to.y); }
};

std::vector<Line> lines(const std::vector<planner::Strip>& strips) {
  const PointM way = plane(strips.front().end) - plane(strips.front().begin);
  const auto frame = planner::RowFrame::along(planner::norm(way) > 0.0 ? way : PointM{1.0, 0.0});
  std::vector<Line> all;
  all.reserve(strips.size());
  for (std::size_t s = 0; s < strips.size(); ++s) {
    all.push_back({s, frame.to(plane(strips[s].begin)), frame.to(plane(strips[s].end))});
  }
  return all;
}

}  // namespace

Length near_work(Length separation, Length narrowest_swath) {
  constexpr Length off_lines = metres(1);
  return separation + std::min(off_lines, 0.2 * narrowest_swath);
}

std::vector<bool> strips_near_others(const planner::Route& route, Length near) {
  const double near_m = near.base();
  std::vector<Line> all = lines(route.strips);
  std::stable_sort(all.begin(), all.end(),
                   [](const Line& a, const Line& b) { return a.low_m() < b.low_m(); });
  std::vector<bool> is_near(route.strips.size(), false);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Line& a = all[i];
    for (std::size_t j = i + 1; j < all.size() && all[j].low_m() < a.high_m() + near_m; ++j) {
      const Line& b = all[j];
      if (is_near[a.strip] && is_near[b.strip]) continue;
      if (planner::apart_m(a.from, a.to, b.from, b.to) >= near_m) continue;
      is_near[a.strip] = is_near[b.strip] = true;
    }
  }
  return is_near;
}

}  // namespace furrow::scheduler
