#include "app/results/footprint.hpp"

#include "app/results/land.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
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

double sampled_outside_m(const Field& field, const StripFrame& frame, double along_m, Interval part,
                         double step_m) {
  const double width_m = part.to_m - part.from_m;
  const double count = std::max(1.0, std::ceil(width_m / step_m));
  double outside_m = 0;
  for (double i = 0; i < count; ++i) {
    const double across_m = part.from_m + (i + 0.5) * width_m / count;
    if (!contains(field, frame.at(along_m, across_m))) outside_m += width_m / count;
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

bool is_on_lattice(const planner::Route& route) {
  return std::none_of(route.strips.begin(), route.strips.end(), planner::sprays_ends);
}

// How often each place of a lattice over the field was wetted.
class Samples {
 public:
  Samples(const Field& field, double swath_m) : field_{field} {
    double east_m = -INFINITY, north_m = -INFINITY;
    for (const FieldPoint p : field.boundary) {
      west_m_ = std::min(west_m_, p.x.base() - swath_m);
      south_m_ = std::min(south_m_, p.y.base() - swath_m);
      east_m = std::max(east_m, p.x.base() + swath_m);
      north_m = std::max(north_m, p.y.base() + swath_m);
    }
    const double wide_m = east_m - west_m_, high_m = north_m - south_m_;
    step_m_ = std::max(swath_m / 8, std::sqrt(wide_m * high_m / most_samples));
    columns_ = static_cast<std::size_t>(std::ceil(wide_m / step_m_));
    rows_ = static_cast<std::size_t>(std::ceil(high_m / step_m_));
    times_.resize(columns_ * rows_);
  }

  // Wets a rectangle around `center`, `ahead` of length 1.
  void wet(FieldPoint center, FieldVector ahead, double half_length_m, double half_width_m) {
    const double x = center.x.base(), y = center.y.base();
    const double ux = ahead.x.base(), uy = ahead.y.base();
    const double reach_x = std::abs(ux) * half_length_m + std::abs(uy) * half_width_m;
    const double reach_y = std::abs(uy) * half_length_m + std::abs(ux) * half_width_m;
    const std::size_t left = column(x - reach_x - west_m_, columns_);
    const std::size_t right = column(x + reach_x - west_m_ + step_m_, columns_);
    const std::size_t top = column(y + reach_y - south_m_ + step_m_, rows_);
    for (std::size_t r = column(y - reach_y - south_m_, rows_); r < top; ++r) {
      for (std::size_t c = left; c < right; ++c) {
        const double dx = at_m(c, west_m_) - x, dy = at_m(r, south_m_) - y;
        const double along = dx * ux + dy * uy, across = dx * uy - dy * ux;
        // Half open, so that cells side by side share no sample.
        const bool is_wet = along >= -half_length_m && along < half_length_m &&
                            across >= -half_width_m && across < half_width_m;
        times_[r * columns_ + c] += is_wet;
      }
    }
  }

  FootprintFigures figures() const {
    FootprintFigures sum{};
    std::vector<double> edges_m;
    for (std::size_t r = 0; r < rows_; ++r) {
      crossings(at_m(r, south_m_), edges_m);
      std::size_t next = 0;
      for (std::size_t c = 0; c < columns_; ++c) {
        while (next < edges_m.size() && edges_m[next] <= at_m(c, west_m_)) ++next;
        const bool is_land = next % 2 == 1;
        const std::uint32_t times = times_[r * columns_ + c];
        sum.wetted_m2 += times > 0;
        sum.overlap_m2 += times > 1 ? times - 1 : 0;
        sum.missed_m2 += is_land && times == 0;
        sum.outside_m2 += !is_land && times > 0;
      }
    }
    for (double* area : {&sum.wetted_m2, &sum.overlap_m2, &sum.missed_m2, &sum.outside_m2}) {
      *area *= step_m_ * step_m_;
    }
    return sum;
  }

 private:
  static constexpr double most_samples = 4e6;

  double at_m(std::size_t index, double low_m) const {
    return low_m + (static_cast<double>(index) + 0.5) * step_m_;
  }
  std::size_t column(double from_low_m, std::size_t count) const {
    return static_cast<std::size_t>(
        std::clamp(std::floor(from_low_m / step_m_), 0.0, static_cast<double>(count)));
  }

  // Where the edges of boundary and holes cross a line from west to east.
  void crossings(double y_m, std::vector<double>& edges_m) const {
    edges_m.clear();
    const auto cross = [&](const Ring& ring) {
      for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const double yi = ring[i].y.base(), yj = ring[j].y.base();
        if ((yi > y_m) == (yj > y_m)) continue;
        const double xi = ring[i].x.base(), xj = ring[j].x.base();
        edges_m.push_back((xj - xi) * (y_m - yi) / (yj - yi) + xi);
      }
    };
    cross(field_.boundary);
    for (const Ring& hole : field_.holes) cross(hole);
    std::sort(edges_m.begin(), edges_m.end());
  }

  const Field& field_;
  double west_m_ = INFINITY, south_m_ = INFINITY, step_m_;
  std::size_t columns_, rows_;
  std::vector<std::uint16_t> times_;
};

FootprintFigures sampled_footprint(const Field& field, const planner::Route& route,
                                   std::span<const Pass> passes) {
  Samples samples{field, route.cell.base()};
  for (const Pass& pass : passes) {
    const planner::Strip& strip = route.strips[planner::strip_of(route, pass.cell)];
    const FieldPoint begin = planner::start_point(route, strip, pass.cell);
    const FieldPoint end = planner::stop_point(route, strip, pass.cell);
    const double length_m = distance(begin, end).base();
    if (length_m == 0.0) continue;
    const FieldVector way = end - begin;
    const FieldVector ahead{(1.0 / length_m) * way.x, (1.0 / length_m) * way.y};
    const FieldVector right{pass.offset_m * ahead.y, -pass.offset_m * ahead.x};
    samples.wet(route.centers[pass.cell] + right, ahead, 0.5 * length_m, 0.5 * route.cell.base());
  }
  return samples.figures();
}

}  // namespace

FootprintFigures footprint(const Field& field, const planner::Route& route,
                           std::span<const Pass> passes, double work_direction_deg) {
  if (!is_on_lattice(route)) return sampled_footprint(field, route, passes);
  const double direction_rad = work_direction_deg * std::numbers::pi / 180;
  const StripFrame frame{std::sin(direction_rad), std::cos(direction_rad)};
  const double cell_m = route.cell.base();
  const double origin_m = frame.along_m(route.centers.front());
  const auto row_of = [&](FieldPoint p) {
    return std::llround((frame.along_m(p) - origin_m) / cell_m);
  };
  const auto swath_at = [&](double across_m) {
    return Interval{across_m - cell_m / 2, across_m + cell_m / 2};
  };

  std::map<long long, Row> rows;
  for (const auto* cells : {&route.centers, &route.missed}) {
    for (const FieldPoint p : *cells) {
      rows[row_of(p)].workable.push_back(swath_at(frame.across_m(p)));
    }
  }
  const std::vector<double> sense = senses(route, frame);
  for (const Pass& pass : passes) {
    const FieldPoint p = route.centers[pass.cell];
    const double across_m = frame.across_m(p) + sense[pass.cell] * pass.offset_m;
    rows[row_of(p)].wetted.push_back(swath_at(across_m));
  }

  FootprintFigures sum{};
  for (auto& [index, row] : rows) {
    const double along_m = origin_m + static_cast<double>(index) * cell_m;
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

}  // namespace furrow::app
