#include "app/results/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace furrow::app {
namespace {

struct Interval {
  double from_m, to_m;
};

// One line of cells across the strips: positions are metres to the right of the work direction.
struct Row {
  std::vector<Interval> workable, wetted;
};

// The frame of the strips: unit vectors along them and to their right.
struct StripFrame {
  double ahead_x, ahead_y;

  double along_m(FieldPoint p) const { return p.x.base() * ahead_x + p.y.base() * ahead_y; }
  double across_m(FieldPoint p) const { return p.x.base() * ahead_y - p.y.base() * ahead_x; }
  FieldPoint at(double along_m, double across_m) const {
    return at_m(along_m * ahead_x + across_m * ahead_y, along_m * ahead_y - across_m * ahead_x);
  }
};

// Disjoint intervals in rising order that cover the same ground. Gaps of round-off are closed.
std::vector<Interval> merged(std::vector<Interval> parts) {
  constexpr double round_off_m = 1e-9;
  std::sort(parts.begin(), parts.end(), [](Interval a, Interval b) {
    return a.from_m != b.from_m ? a.from_m < b.from_m : a.to_m < b.to_m;
  });
  std::vector<Interval> whole;
  for (const Interval part : parts) {
    if (!whole.empty() && part.from_m <= whole.back().to_m + round_off_m) {
      whole.back().to_m = std::max(whole.back().to_m, part.to_m);
    } else {
      whole.push_back(part);
    }
  }
  return whole;
}

double length_m(const std::vector<Interval>& parts) {
  double sum_m = 0;
  for (const Interval part : parts) sum_m += part.to_m - part.from_m;
  return sum_m;
}

// Ground of `from` that `taken` does not cover; both disjoint and rising.
std::vector<Interval> without(const std::vector<Interval>& from,
                              const std::vector<Interval>& taken) {
  std::vector<Interval> left;
  for (Interval part : from) {
    for (const Interval cut : taken) {
      if (cut.to_m <= part.from_m || cut.from_m >= part.to_m) continue;
      if (cut.from_m > part.from_m) left.push_back({part.from_m, cut.from_m});
      part.from_m = std::min(cut.to_m, part.to_m);
    }
    if (part.to_m > part.from_m) left.push_back(part);
  }
  return left;
}

bool is_on_land(const Field& field, FieldPoint p) {
  return contains(field.boundary, p) &&
         std::none_of(field.holes.begin(), field.holes.end(),
                      [&](const Ring& hole) { return contains(hole, p); });
}

double sampled_outside_m(const Field& field, const StripFrame& frame, double along_m, Interval part,
                         double step_m) {
  const double width_m = part.to_m - part.from_m;
  const double count = std::max(1.0, std::ceil(width_m / step_m));
  double outside_m = 0;
  for (double i = 0; i < count; ++i) {
    const double across_m = part.from_m + (i + 0.5) * width_m / count;
    if (!is_on_land(field, frame.at(along_m, across_m))) outside_m += width_m / count;
  }
  return outside_m;
}

// +1 for cells flown along the work direction, -1 against it; a strip of one cell counts as along.
std::vector<double> senses(const planner::Route& route, const StripFrame& frame) {
  std::vector<double> sense(route.centers.size(), 1.0);
  for (const planner::Strip& strip : route.strips) {
    if (frame.along_m(strip.to) >= frame.along_m(strip.from)) continue;
    for (std::uint32_t i = strip.cells.first; i < end(strip.cells); ++i) sense[i] = -1.0;
  }
  return sense;
}

// By where along the strips they lie [m], rising.
std::vector<std::pair<double, Row>> rows(const planner::Route& route, std::span<const Pass> passes,
                                         const StripFrame& frame) {
  const double cell_m = route.cell.base();
  const double origin_m = frame.along_m(route.centers.front());
  const auto swath_at = [&](double across_m) {
    return Interval{across_m - cell_m / 2, across_m + cell_m / 2};
  };
  std::map<long long, Row> by_index;
  const auto row_of = [&](FieldPoint p) -> Row& {
    return by_index[std::llround((frame.along_m(p) - origin_m) / cell_m)];
  };
  for (const auto* cells : {&route.centers, &route.missed}) {
    for (const FieldPoint p : *cells) row_of(p).workable.push_back(swath_at(frame.across_m(p)));
  }
  const std::vector<double> sense = senses(route, frame);
  for (const Pass& pass : passes) {
    const FieldPoint p = route.centers[pass.cell];
    const double across_m = frame.across_m(p) + sense[pass.cell] * pass.offset_m;
    row_of(p).wetted.push_back(swath_at(across_m));
  }
  std::vector<std::pair<double, Row>> all;
  for (auto& [index, row] : by_index) {
    all.emplace_back(origin_m + static_cast<double>(index) * cell_m, std::move(row));
  }
  return all;
}

}  // namespace

FootprintFigures footprint(const Field& field, const planner::Route& route,
                           std::span<const Pass> passes, double work_direction_deg) {
  const double direction_rad = work_direction_deg * std::numbers::pi / 180;
  const StripFrame frame{std::sin(direction_rad), std::cos(direction_rad)};
  const double cell_m = route.cell.base();
  FootprintFigures sum{};
  for (auto& [along_m, row] : rows(route, passes, frame)) {
    const double sprayed_m = length_m(row.wetted);
    const auto workable = merged(std::move(row.workable));
    const auto wetted = merged(std::move(row.wetted));
    sum.wetted_m2 += length_m(wetted) * cell_m;
    sum.overlap_m2 += (sprayed_m - length_m(wetted)) * cell_m;
    sum.missed_m2 += length_m(without(workable, wetted)) * cell_m;
    for (const Interval part : without(wetted, workable)) {
      sum.outside_m2 += sampled_outside_m(field, frame, along_m, part, cell_m / 16) * cell_m;
    }
  }
  return sum;
}

FootprintFigures footprint(const planner::SprayedAreas& areas) {
  return {.wetted_m2 = (areas.covered + areas.outside).base(),
          .missed_m2 = areas.missed.base(),
          .overlap_m2 = areas.repeated.base(),
          .outside_m2 = areas.outside.base()};
}

}  // namespace furrow::app
