#include "planner/avoidance/areas.hpp"

#include "planner/coverage/geos.hpp"
#include "planner/coverage/overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace furrow::planner {
namespace {

constexpr double line_step_m = 0.25;

enum Layer : std::size_t { planned, excluded, flown };

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

struct Crossing {
  std::size_t line;
  double place_m;
  int turn;  // +1 into, -1 out of the outline
};

std::vector<Crossing> crossings_of(const RingM& ring, const WindowM& window,
                                   const WindowLines& lines) {
  std::vector<Crossing> crossings;
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
      crossings.push_back({static_cast<std::size_t>(k), a.y + share * (b.y - a.y), turn});
    }
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return a.line != b.line ? a.line < b.line : a.place_m < b.place_m;
  });
  return crossings;
}

// Ground that the outline passes twice is marked once.
void mark(const RingM& ring, Layer layer, const WindowM& window, const WindowLines& lines,
          AreaMarks& marks) {
  int winding = 0;
  double from_m = 0;
  std::size_t line = 0;
  for (const Crossing& c : crossings_of(ring, window, lines)) {
    // Where a corner lies on a line, rounding may leave that one open.
    if (std::exchange(line, c.line) != c.line) winding = 0;
    const int before = winding;
    winding += c.turn;
    if (before == 0) from_m = c.place_m;
    if (winding != 0 || c.place_m <= from_m) continue;
    marks.push_back({c.line, from_m, layer, 1});
    marks.push_back({c.line, c.place_m, layer, -1});
  }
}

void mark(const CircleM& circle, const WindowM& window, const WindowLines& lines,
          AreaMarks& marks) {
  const PointM at = window.frame.to(circle.center - window.origin);
  for (std::size_t k = 0; k < lines.count; ++k) {
    const double off = lines.first_m + static_cast<double>(k) * lines.step_m - at.x;
    if (std::abs(off) >= circle.radius_m) continue;
    const double half = std::sqrt(circle.radius_m * circle.radius_m - off * off);
    marks.push_back({k, at.y - half, excluded, 1});
    marks.push_back({k, at.y + half, excluded, -1});
  }
}

AreaMarks in_order(AreaMarks marks) {
  std::stable_sort(marks.begin(), marks.end(),
                   [](const AreaMark& a, const AreaMark& b) { return a.line < b.line; });
  return marks;
}

WrongArea on_line(AreaMarks& marks) {
  std::sort(marks.begin(), marks.end(),
            [](const AreaMark& a, const AreaMark& b) { return a.place_m < b.place_m; });
  WrongArea wrong{0, 0};
  std::array<int, 3> n{};
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (i > 0) {
      const double width = marks[i].place_m - marks[i - 1].place_m;
      if (n[planned] > 0 && n[excluded] == 0 && n[flown] == 0) wrong.missed_m2 += width;
      if (n[flown] > 1) wrong.repeated_m2 += (n[flown] - 1) * width;
    }
    n[marks[i].layer] += marks[i].step;
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

}  // namespace

AreaWindow::AreaWindow(const WindowM& window, const std::vector<FootprintM>& straight,
                       const std::vector<CircleM>& circles, const std::vector<RingM>& rings)
    : window_{window} {
  const double count = std::max(1.0, std::ceil((window.high_m - window.low_m) / line_step_m));
  lines_.step_m = (window.high_m - window.low_m) / count;
  lines_.first_m = window.low_m + lines_.step_m / 2;
  lines_.count = static_cast<std::size_t>(count);
  AreaMarks marks;
  for (const FootprintM& f : straight) mark(outline(f), planned, window_, lines_, marks);
  for (const CircleM& c : circles) mark(c, window_, lines_, marks);
  for (const RingM& ring : rings) mark(ring, excluded, window_, lines_, marks);
  still_ = in_order(std::move(marks));
}

AreaMarks AreaWindow::sprayed(const std::vector<FootprintM>& footprints) const {
  AreaMarks marks;
  for (const FootprintM& f : footprints) mark(outline(f), flown, window_, lines_, marks);
  return in_order(std::move(marks));
}

WrongArea AreaWindow::wrong(const std::vector<const AreaMarks*>& sprayed) const {
  std::vector<std::pair<AreaMarks::const_iterator, AreaMarks::const_iterator>> all{
      {still_.begin(), still_.end()}};
  for (const AreaMarks* marks : sprayed) all.emplace_back(marks->begin(), marks->end());
  WrongArea sum{0, 0};
  AreaMarks on;
  for (std::size_t k = 0; k < lines_.count; ++k) {
    on.clear();
    for (auto& [next, end] : all) {
      for (; next != end && next->line == k; ++next) on.push_back(*next);
    }
    const WrongArea wrong = on_line(on);
    sum.missed_m2 += wrong.missed_m2 * lines_.step_m;
    sum.repeated_m2 += wrong.repeated_m2 * lines_.step_m;
  }
  return sum;
}

WrongArea area_in(const WindowM& window, const std::vector<FootprintM>& straight,
                  const std::vector<CircleM>& circles, const std::vector<FootprintM>& sprayed,
                  const std::vector<RingM>& rings) {
  const AreaWindow area{window, straight, circles, rings};
  const AreaMarks marks = area.sprayed(sprayed);
  return area.wrong({&marks});
}

WrongArea area_of(const std::vector<FootprintM>& straight, const std::vector<CircleM>& circles,
                  const std::vector<FootprintM>& sprayed, const std::vector<RingM>& rings) {
  WrongArea wrong{0, 0};
  if (straight.empty()) return wrong;
  const PathM& first = straight.front().path;
  Overlay ground{RowFrame::along(first.back() - first.front())};
  const auto add = [&](const std::vector<FootprintM>& footprints, Layer layer) {
    for (const FootprintM& f : footprints) {
      for (const LandPart& part : widened(f.path, f.half_m)) ground.add(part, layer);
    }
  };
  add(straight, planned);
  add(sprayed, flown);
  for (const CircleM& c : circles) ground.add(disc(c), excluded);
  for (const RingM& ring : rings) ground.add({ring, {}}, excluded);
  ground.measure([&](const Overlay::Counts& n, double area_m2) {
    if (n[planned] > 0 && n[excluded] == 0 && n[flown] == 0) wrong.missed_m2 += area_m2;
    const int again = std::max(0, n[flown] - 1) - std::max(0, n[planned] - 1);
    wrong.repeated_m2 += again * area_m2;
  });
  wrong.repeated_m2 = std::max(0.0, wrong.repeated_m2);
  return wrong;
}

double backswept_m2(double turn_rad, double radius_m, double half_m) {
  const double over_m = std::max(0.0, half_m - radius_m);
  return turn_rad * over_m * over_m / 2;
}

}  // namespace furrow::planner
