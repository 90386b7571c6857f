#include "planner/coverage/swath/joints.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace furrow::planner {
namespace {

constexpr double slack_m = 1e-9;

std::optional<PointM> crossing_of(const GroundStrip& s, const GroundStrip& t) {
  const PointM u = s.b - s.a, v = t.b - t.a;
  const double turn = cross(u, v);
  if (std::abs(turn) < 0.1 * norm(u) * norm(v)) return std::nullopt;  // nearly parallel
  return s.a + (cross(t.a - s.a, v) / turn) * u;
}

// Whether the strip from `a` to `b` still sprays all it did if it ends at `x` of its line.
bool reaches(PointM a, PointM b, PointM x) { return dot(b - a, x - b) >= -slack_m * norm(b - a); }

bool is_ahead(PointM from, PointM to, PointM place) { return dot(to - from, place - from) > 0; }

}  // namespace

bool join_corners(StripOrder& order, const EdgeGrid& edges, Shortening either) {
  bool shortened = false;
  for (std::size_t i = 1; i < order.strips.size(); ++i) {
    GroundStrip& before = order.strips[i - 1].strip;
    GroundStrip& after = order.strips[i].strip;
    PathM& approach = order.strips[i].approach;
    const double way_m = length_m(approach);
    if (approach.empty() || way_m <= slack_m) continue;
    const auto x = crossing_of(before, after);
    if (!x || norm(*x - before.b) > before.half_width_m + slack_m ||
        norm(*x - after.a) > after.half_width_m + slack_m || !is_ahead(before.a, before.b, *x) ||
        !is_ahead(after.b, after.a, *x)) {
      continue;
    }
    const double old_m = norm(before.b - before.a) + norm(after.b - after.a);
    const double new_m = norm(*x - before.a) + norm(after.b - *x);
    const bool shortens = !reaches(before.a, before.b, *x) || !reaches(after.b, after.a, *x);
    if (shortens && either == Shortening::refused) continue;
    if (new_m < old_m - slack_m || new_m > old_m + way_m - slack_m || !edges.sees(before.b, *x) ||
        !edges.sees(*x, after.a)) {
      continue;
    }
    order.route_m += new_m - old_m - way_m;
    order.bound_m = std::min(order.bound_m, order.route_m);
    before.b = after.a = *x;
    approach = {*x, *x};
    shortened = shortened || shortens;
  }
  return shortened;
}

}  // namespace furrow::planner
