#include "planner/avoidance/areas.hpp"

#include "planner/coverage/geos.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow::planner {
namespace {

constexpr double line_step_m = 0.25;

struct Crossing {
  double place_m;
  int turn;  // +1 into, -1 out of the outline
};

// The outline of a footprint: its left side out, its right side back.
RingM outline(const FootprintM& footprint) {
  RingM left, right;
  const PathM& path = footprint.path;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PointM in = i > 0 ? path[i] - path[i - 1] : path[1] - path[0];
    const PointM out = i + 1 < path.size() ? path[i + 1] - path[i] : in;
    const PointM mean = (1 / norm(in)) * in + (1 / norm(out)) * out;
    const double length = norm(mean);
    // At a mitre; bends are small, so that it stays short.
    const double reach_m = footprint.half_m * 2 / std::max(length * length, 0.5) * length;
    const PointM aside = (reach_m / length) * PointM{-mean.y, mean.x};
    left.push_back(path[i] + aside);
    right.push_back(path[i] - aside);
  }
  left.insert(left.end(), right.rbegin(), right.rend());
  return left;
}

// Which lines x = const a window is measured on.
struct Lines {
  double first_m, step_m;
  std::size_t count;
  double at(std::size_t i) const { return first_m + static_cast<double>(i) * step_m; }
};

using Spans = std::vector<std::vector<std::pair<double, double>>>;  // of each line, apart

Spans spans_of(const RingM& ring, const WindowM& window, const Lines& lines) {
  std::vector<std::vector<Crossing>> crossings(lines.count);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    PointM a = window.frame.to(ring[i] - window.origin);
    PointM b = window.frame.to(ring[(i + 1) % ring.size()] - window.origin);
    const int turn = a.x < b.x ? 1 : -1;
    if (a.x > b.x) std::swap(a, b);
    const double from = std::max(0.0, std::ceil((a.x - lines.first_m) / lines.step_m));
    for (double k = from; k < static_cast<double>(lines.count); ++k) {
      const double x = lines.first_m + k * lines.step_m;
      if (x >= b.x) break;
      const double share = (x - a.x) / (b.x - a.x);
      crossings[static_cast<std::size_t>(k)].push_back({a.y + share * (b.y - a.y), turn});
    }
  }
  Spans spans(lines.count);
  for (std::size_t k = 0; k < lines.count; ++k) {
    std::sort(crossings[k].begin(), crossings[k].end(),
              [](const Crossing& a, const Crossing& b) { return a.place_m < b.place_m; });
    int winding = 0;
    double from_m = 0;
    for (const Crossing& c : crossings[k]) {
      const int before = winding;
      winding += c.turn;
      if (before == 0) from_m = c.place_m;
      if (winding == 0 && c.place_m > from_m) spans[k].push_back({from_m, c.place_m});
    }
  }
  return spans;
}

Spans spans_of(const CircleM& circle, const WindowM& window, const Lines& lines) {
  const PointM at = window.frame.to(circle.center - window.origin);
  Spans spans(lines.count);
  for (std::size_t k = 0; k < lines.count; ++k) {
    const double off = lines.at(k) - at.x;
    if (std::abs(off) >= circle.radius_m) continue;
    const double half = std::sqrt(circle.radius_m * circle.radius_m - off * off);
    spans[k].push_back({at.y - half, at.y + half});
  }
  return spans;
}

enum class Layer { planned, excluded, flown };
struct Edge {
  double place_m;
  Layer layer;
  int step;
};

WrongArea on_line(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.place_m < b.place_m; });
  WrongArea wrong{0, 0};
  int planned = 0, excluded = 0, flown = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i > 0) {
      const double width = edges[i].place_m - edges[i - 1].place_m;
      if (planned > 0 && excluded == 0 && flown == 0) wrong.missed_m2 += width;
      if (flown > 1) wrong.repeated_m2 += (flown - 1) * width;
    }
    int& count = edges[i].layer == Layer::planned    ? planned
                 : edges[i].layer == Layer::excluded ? excluded
                                                     : flown;
    count += edges[i].step;
  }
  return wrong;
}

LandPart disc(const CircleM& circle) {
  constexpr int corners = 48;
  const double step = 2 * std::numbers::pi / corners;
  // As much area as the circle.
  const double reach_m = circle.radius_m * std::sqrt(step / std::sin(step));
  LandPart made;
  for (int i = 0; i < corners; ++i) {
    made.outer.push_back(circle.center + reach_m * PointM{std::cos(i * step), std::sin(i * step)});
  }
  return made;
}

LandParts widened(const std::vector<FootprintM>& footprints) {
  LandParts all;
  for (const FootprintM& f : footprints) {
    const LandParts wide = widened(f.path, f.half_m);
    all.insert(all.end(), wide.begin(), wide.end());
  }
  return all;
}

}  // namespace

WrongArea area_in(const WindowM& window, const std::vector<FootprintM>& straight,
                  const std::vector<CircleM>& circles, const std::vector<FootprintM>& flown,
                  const std::vector<RingM>& rings) {
  const double count = std::max(1.0, std::ceil((window.high_m - window.low_m) / line_step_m));
  const double step_m = (window.high_m - window.low_m) / count;
  const Lines lines{window.low_m + step_m / 2, step_m, static_cast<std::size_t>(count)};
  std::vector<std::vector<Edge>> edges(lines.count);
  const auto add = [&](const Spans& spans, Layer layer) {
    for (std::size_t k = 0; k < lines.count; ++k) {
      for (const auto& [from_m, to_m] : spans[k]) {
        edges[k].push_back({from_m, layer, 1});
        edges[k].push_back({to_m, layer, -1});
      }
    }
  };
  for (const FootprintM& f : straight) add(spans_of(outline(f), window, lines), Layer::planned);
  for (const CircleM& c : circles) add(spans_of(c, window, lines), Layer::excluded);
  for (const RingM& ring : rings) add(spans_of(ring, window, lines), Layer::excluded);
  for (const FootprintM& f : flown) add(spans_of(outline(f), window, lines), Layer::flown);
  WrongArea sum{0, 0};
  for (std::vector<Edge>& line : edges) {
    const WrongArea wrong = on_line(line);
    sum.missed_m2 += wrong.missed_m2 * step_m;
    sum.repeated_m2 += wrong.repeated_m2 * step_m;
  }
  return sum;
}

WrongArea area_of(const std::vector<FootprintM>& straight, const std::vector<CircleM>& circles,
                  const std::vector<FootprintM>& flown, const std::vector<RingM>& rings) {
  const LandParts sprayed = widened(flown), once = united(sprayed);
  // What is not sprayed is in few places: obstacles are taken from it alone.
  LandParts missed = subtracted(united(widened(straight)), once), taken;
  for (const CircleM& c : circles) taken.push_back(disc(c));
  for (const RingM& ring : rings) taken.push_back({ring, {}});
  if (!missed.empty() && !taken.empty()) missed = subtracted(missed, united(taken));
  return {area_m2(missed), std::max(0.0, area_m2(sprayed) - area_m2(once))};
}

double repeated_m2(const std::vector<FootprintM>& flown) {
  const LandParts sprayed = widened(flown);
  return std::max(0.0, area_m2(sprayed) - area_m2(united(sprayed)));
}

double backswept_m2(double turn_rad, double radius_m, double half_m) {
  const double over_m = std::max(0.0, half_m - radius_m);
  return turn_rad * over_m * over_m / 2;
}

}  // namespace furrow::planner
