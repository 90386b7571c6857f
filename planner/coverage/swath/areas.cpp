#include "planner/coverage/swath/areas.hpp"

#include "planner/coverage/geos.hpp"
#include "planner/coverage/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace furrow::planner {
namespace {

constexpr double shortest_m = 1e-9;

// Rows flown side by side, joined into one outline without any overlay. Overlays take the square of
// an outline's corners, so that no stack has all rows of a large field.
class RowStack {
 public:
  RowStack(PointM a, PointM b, double half_m)
      : frame_{RowFrame::along(b - a)}, half_m_{half_m}, spans_{span(a, b)} {}

  // Whether the row lies beside the last one, at most one width and at least half of it away, with
  // a stretch alongside; adds it if so.
  bool takes(PointM a, PointM b, double half_m) {
    const Span next = span(a, b), last = spans_.back();
    const double step_m = next.v_m - last.v_m, away_m = std::abs(step_m);
    const bool straight = std::abs(frame_.to(b).y - frame_.to(a).y) <= same_m;
    const bool beside = away_m <= 2 * half_m_ + same_m && away_m >= half_m_ - same_m &&
                        (spans_.size() == 1 || (step_m > 0) == upwards_);
    const bool overlaps =
        std::min(next.high_m, last.high_m) - std::max(next.low_m, last.low_m) > same_m;
    if (half_m != half_m_ || !straight || !beside || !overlaps) return false;
    upwards_ = step_m > 0;
    spans_.push_back(next);
    return true;
  }

  bool is_full() const { return spans_.size() >= most_rows; }
  // The next stack begins with the last row of this one, so that no seam is left between them.
  void begin_next() { spans_ = {spans_.back()}; }

  LandPart outline() const {
    std::vector<Span> rows = spans_;
    if (!upwards_) std::reverse(rows.begin(), rows.end());
    RingM right, left;
    double bottom_m = rows.front().v_m - half_m_;
    const auto band = [&](double low_m, double high_m, double top_m) {
      if (top_m <= bottom_m) return;
      right.insert(right.end(), {{high_m, bottom_m}, {high_m, top_m}});
      left.insert(left.end(), {{low_m, bottom_m}, {low_m, top_m}});
      bottom_m = top_m;
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Span row = rows[i];
      const double top_m = row.v_m + half_m_;
      const bool overlapped = i + 1 < rows.size() && rows[i + 1].v_m - half_m_ < top_m - same_m;
      band(row.low_m, row.high_m, overlapped ? rows[i + 1].v_m - half_m_ : top_m);
      if (!overlapped) continue;
      const Span next = rows[i + 1];
      band(std::min(row.low_m, next.low_m), std::max(row.high_m, next.high_m), top_m);
    }
    LandPart made{std::move(right), {}};
    made.outer.insert(made.outer.end(), left.rbegin(), left.rend());
    for (PointM& p : made.outer) p = frame_.from(p);
    return made;
  }

 private:
  static constexpr double same_m = 1e-8;
  static constexpr std::size_t most_rows = 64;
  struct Span {
    double low_m, high_m, v_m;
  };
  Span span(PointM a, PointM b) const {
    const PointM p = frame_.to(a), q = frame_.to(b);
    return {std::min(p.x, q.x), std::max(p.x, q.x), p.y};
  }

  RowFrame frame_;
  double half_m_;
  std::vector<Span> spans_;
  bool upwards_ = true;
};

PathM without_repeats(const PathM& path) {
  PathM made;
  for (const PointM p : path) {
    if (made.empty() || norm(p - made.back()) > shortest_m) made.push_back(p);
  }
  return made;
}

// Length times width, and at bends the wedge on the outside of the turn.
double swept_m2(const SprayedRun& run) {
  const PathM path = without_repeats(run.path);
  double sum = length_m(path) * run.width_m;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const PointM in = path[i] - path[i - 1], out = path[i + 1] - path[i];
    const double turn = std::abs(std::atan2(cross(in, out), dot(in, out)));
    sum += turn / 2 * (run.width_m / 2) * (run.width_m / 2);
  }
  return sum;
}

LandParts footprints(const std::vector<SprayedRun>& runs) {
  LandParts made;
  std::optional<RowStack> stack;
  for (const SprayedRun& run : runs) {
    const PathM path = without_repeats(run.path);
    if (path.size() < 2) continue;
    const double half_m = run.width_m / 2;
    if (stack && stack->is_full()) {
      made.push_back(stack->outline());
      stack->begin_next();
    }
    if (path.size() > 2) {
      LandParts wide = widened(path, half_m);
      made.insert(made.end(), wide.begin(), wide.end());
    } else if (!stack || !stack->takes(path[0], path[1], half_m)) {
      if (stack) made.push_back(stack->outline());
      stack.emplace(path[0], path[1], half_m);
    }
  }
  if (stack) made.push_back(stack->outline());
  return made;
}

// Of the first leg, if there is one.
RowFrame frame_along(const std::vector<SprayedRun>& runs) {
  for (const SprayedRun& run : runs) {
    const PathM path = without_repeats(run.path);
    if (path.size() > 1) return RowFrame::along(path[1] - path[0]);
  }
  return RowFrame{1, 0};
}

// One by one, the largest first: what is left is small, and later ones touch little of it.
LandParts less(const LandParts& land, LandParts taken) {
  std::stable_sort(taken.begin(), taken.end(),
                   [](const LandPart& a, const LandPart& b) { return area_m2(a) > area_m2(b); });
  LandParts left = land;
  for (const LandPart& part : taken) left = subtracted(left, {part});
  return left;
}

}  // namespace

SprayedAreas sprayed_areas(const std::vector<SprayedRun>& runs, const LandParts& land) {
  enum Kind : std::size_t { flown, owned };
  Overlay ground{frame_along(runs)};
  for (const LandPart& part : footprints(runs)) ground.add(part, flown);
  for (const LandPart& part : land) ground.add(part, owned);
  double sprayed_m2 = 0, once_m2 = 0, outside_m2 = 0;
  for (const SprayedRun& run : runs) sprayed_m2 += swept_m2(run);
  ground.measure([&](const Overlay::Counts& n, double area_m2) {
    if (n[flown] == 0) return;
    once_m2 += area_m2;
    if (n[owned] == 0) outside_m2 += area_m2;
  });
  const double covered_m2 = once_m2 - outside_m2;
  return {.sprayed = square_metres(sprayed_m2),
          .covered = square_metres(covered_m2),
          .missed = square_metres(std::max(0.0, area_m2(land) - covered_m2)),
          .repeated = square_metres(std::max(0.0, sprayed_m2 - once_m2)),
          .outside = square_metres(outside_m2)};
}

LandParts missed_land(const std::vector<SprayedRun>& runs, const LandParts& land) {
  return less(land, footprints(runs));
}

}  // namespace furrow::planner
