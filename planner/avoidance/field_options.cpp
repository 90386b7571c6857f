#include "planner/avoidance/field_options.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

constexpr double sample_rad = 0.15;
constexpr double nothing_m2 = 1e-6;

PointM along(const PassM& pass, double at_m) {
  return pass.a + (at_m / pass.length_m()) * (pass.b - pass.a);
}

double backswept_of(const CurveM& curve, double half_m) {
  double sum = 0;
  for (const Bend& bend : curve.bends) {
    if (bend.curvature_per_m == 0) continue;
    const double radius_m = 1 / std::abs(bend.curvature_per_m);
    sum += backswept_m2(bend.length_m / radius_m, radius_m, half_m);
  }
  return sum;
}

// Of barriers that come within `reach_m` of `at`.
std::vector<RingM> rings_near(const Room& room, PointM at, double reach_m) {
  std::vector<RingM> near;
  for (const BarrierM& barrier : room.barriers()) {
    PathM outline = barrier.ring;
    outline.push_back(outline.front());
    if (distance_m(at, outline) < reach_m) near.push_back(barrier.ring);
  }
  return near;
}

void append(PathM& path, PointM at) {
  if (path.empty() || norm(at - path.back()) > 1e-9) path.push_back(at);
}

}  // namespace

double wrong_alone_m2(const std::vector<PassM>& passes, const CrowdOption& option,
                      const Room& room) {
  const PassM& pass = passes.front();
  const double half_m = pass.width_m / 2;
  const RowFrame frame = RowFrame::along(pass.b - pass.a);
  const WindowM window{pass.a, frame, option.low_m - half_m, option.high_m + half_m};
  std::vector<FootprintM> straight, flown;
  const auto fly = [&](PathM path) {
    if (path.size() > 1) flown.push_back({std::move(path), half_m});
  };
  PathM path{pass.a};
  const bool sprays = option.conduct == Conduct::sprayed;
  if (sprays) {
    const double sample_m = sample_rad / std::abs(option.curve.bends.front().curvature_per_m);
    for (const PointM at : sampled(option.curve, sample_m)) append(path, at);
  } else {
    append(path, along(pass, option.low_m));
    fly(std::move(path));
    path = {along(pass, option.high_m)};
  }
  append(path, pass.b);
  fly(std::move(path));
  for (const PassM& p : passes) straight.push_back({{p.a, p.b}, p.width_m / 2});
  flown.insert(flown.end(), straight.begin() + 1, straight.end());
  std::vector<CircleM> circles;
  for (const std::size_t i : room.circles_near(pass.a, pass.b, 2 * pass.width_m)) {
    circles.push_back(room.circles()[i]);
  }
  const PointM middle = along(pass, (option.low_m + option.high_m) / 2);
  const auto rings = rings_near(room, middle, option.high_m - option.low_m + 2 * pass.width_m);
  return area_in(window, straight, circles, flown, rings).sum_m2() +
         (sprays ? backswept_of(option.curve, half_m) : 0.0);
}

FieldOptions::FieldOptions(std::vector<PassM> passes, const Room& room, double turn_m)
    : passes_{std::move(passes)}, turn_m_{turn_m} {
  for (std::size_t p = 0; p < passes_.size(); ++p) {
    const auto targets = targets_of(passes_[p], room);
    targets_ += targets.size();
    for (Crowd& crowd : crowds_of(passes_[p], targets, room, turn_m)) {
      crowds_.push_back({p, std::move(crowd)});
    }
  }
  for (const PlacedCrowd& placed : crowds_) {
    std::vector<PathM>& paths = around_.emplace_back();
    for (const CrowdOption& option : placed.crowd.options) {
      paths.push_back(sampled(option.curve, sample_rad * turn_m_));
    }
  }
  for (std::size_t c = 0; c < crowds_.size(); ++c) windows_.push_back(window_of(c, room));
}

FieldOptions::Window FieldOptions::window_of(std::size_t c, const Room& room) const {
  const PassM& pass = passes_[crowds_[c].pass];
  const double half_m = pass.width_m / 2;
  double low_m = INFINITY, high_m = -INFINITY, aside_m = 0;
  const RowFrame frame = RowFrame::along(pass.b - pass.a);
  for (std::size_t o = 0; o < around_[c].size(); ++o) {
    const CrowdOption& option = crowds_[c].crowd.options[o];
    low_m = std::min(low_m, option.low_m);
    high_m = std::max(high_m, option.high_m);
    if (option.conduct == Conduct::blocked) continue;
    for (const PointM p : around_[c][o]) {
      aside_m = std::max(aside_m, std::abs(frame.to(p - pass.a).y));
    }
  }
  Window window{
      {pass.a, frame, low_m - half_m, high_m + half_m}, {}, 0, aside_m + half_m, {}, {}, {}};
  std::vector<FootprintM> straight;
  std::vector<CircleM> circles;
  window.middle = along(pass, (low_m + high_m) / 2);
  window.radius_m = std::hypot((high_m - low_m) / 2 + half_m, aside_m + half_m);
  for (std::size_t p = 0; p < passes_.size(); ++p) {
    const double reach_m = window.radius_m + passes_[p].width_m / 2;
    if (distance_m(window.middle, passes_[p].a, passes_[p].b) < reach_m) {
      window.passes.push_back(p);
      straight.push_back({{passes_[p].a, passes_[p].b}, passes_[p].width_m / 2});
    }
  }
  for (const std::size_t i : room.circles_near(window.middle, window.middle, window.radius_m)) {
    circles.push_back(room.circles()[i]);
  }
  const auto rings = rings_near(room, window.middle, window.radius_m);
  window.area.emplace(window.lines, straight, circles, rings);
  for (const FootprintM& f : straight) window.straight.push_back(window.area->sprayed({f}));
  return window;
}

std::vector<FootprintM> FieldOptions::footprints(std::size_t p,
                                                 const std::vector<Taken>& taken) const {
  const PassM& pass = passes_[p];
  std::vector<FootprintM> made;
  PathM path{pass.a};
  const auto close = [&] {
    if (path.size() > 1) made.push_back({std::move(path), pass.width_m / 2});
    path.clear();
  };
  for (const Taken& t : taken) {
    if (crowds_[t.crowd].pass != p) continue;
    const CrowdOption& option = crowds_[t.crowd].crowd.options[t.option];
    append(path, along(pass, option.low_m));
    if (option.conduct == Conduct::sprayed) {
      for (const PointM at : around_[t.crowd][t.option]) append(path, at);
    } else {
      close();
    }
    append(path, along(pass, option.high_m));
  }
  append(path, pass.b);
  close();
  return made;
}

// @param taken  At least one; all of one pass, in order.
FieldOptions::FlownPass FieldOptions::flown_in(const Window& window,
                                               const std::vector<Taken>& taken) const {
  const std::size_t p = crowds_[taken.front().crowd].pass;
  return {p, window.area->sprayed(footprints(p, taken))};
}

std::vector<FieldOptions::FlownPass> FieldOptions::options_in(const Window& window,
                                                              std::size_t crowd) const {
  std::vector<FlownPass> made;
  for (std::size_t o = 0; o < crowds_[crowd].crowd.options.size(); ++o) {
    made.push_back(flown_in(window, {{crowd, o}}));
  }
  return made;
}

// All other passes straight.
double FieldOptions::wrong_m2(const Window& window,
                              const std::vector<const FlownPass*>& flown) const {
  std::vector<const AreaMarks*> sprayed;
  for (std::size_t i = 0; i < window.passes.size(); ++i) {
    const AreaMarks* marks = &window.straight[i];
    for (const FlownPass* f : flown) {
      if (f->pass == window.passes[i]) marks = &f->marks;
    }
    sprayed.push_back(marks);
  }
  return window.area->wrong(sprayed).sum_m2();
}

FieldOptions::Alone FieldOptions::alone(std::size_t crowd) const {
  const Window& window = windows_[crowd];
  Alone made{wrong_m2(window, {}), {}};
  for (const FlownPass& f : options_in(window, crowd)) {
    made.wrong_m2.push_back(wrong_m2(window, {&f}));
  }
  return made;
}

// Whether their windows meet, seen along the pass of `a`.
bool FieldOptions::may_interplay(std::size_t a, std::size_t b) const {
  const Window &one = windows_[a], &other = windows_[b];
  if (norm(one.middle - other.middle) >= one.radius_m + other.radius_m) return false;
  PointM low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const double x : {other.lines.low_m, other.lines.high_m}) {
    for (const double y : {-other.aside_m, other.aside_m}) {
      const PointM corner = other.lines.origin + other.lines.frame.from({x, y});
      const PointM seen = one.lines.frame.to(corner - one.lines.origin);
      low = {std::min(low.x, seen.x), std::min(low.y, seen.y)};
      high = {std::max(high.x, seen.x), std::max(high.y, seen.y)};
    }
  }
  return low.x < one.lines.high_m && high.x > one.lines.low_m && low.y < one.aside_m &&
         high.y > -one.aside_m;
}

// Whether any of a crowd's options changes what the window holds.
bool FieldOptions::shows_in(const Window& window, const std::vector<FlownPass>& options) const {
  const auto pass = std::find(window.passes.begin(), window.passes.end(), options.front().pass);
  if (pass == window.passes.end()) return false;
  const auto& straight = window.straight[static_cast<std::size_t>(pass - window.passes.begin())];
  return std::any_of(options.begin(), options.end(),
                     [&](const FlownPass& f) { return f.marks != straight; });
}

std::optional<Interplay> FieldOptions::interplay(std::size_t a, const Alone& a_alone,
                                                 std::size_t b) const {
  const Window& window = windows_[a];
  const std::vector<FlownPass> of_b = options_in(window, b);
  if (!shows_in(window, of_b)) return std::nullopt;
  const std::vector<FlownPass> of_a = options_in(window, a);
  const bool is_one_pass = crowds_[a].pass == crowds_[b].pass;
  std::vector<double> only_b;
  only_b.reserve(of_b.size());
  for (const FlownPass& f : of_b) only_b.push_back(wrong_m2(window, {&f}));
  Interplay made{a, b, {}};
  bool matters = false;
  for (std::size_t oa = 0; oa < of_a.size(); ++oa) {
    for (std::size_t ob = 0; ob < of_b.size(); ++ob) {
      std::optional<FlownPass> both;
      if (is_one_pass) both = flown_in(window, {{a, oa}, {b, ob}});
      const double both_m2 =
          both ? wrong_m2(window, {&*both}) : wrong_m2(window, {&of_a[oa], &of_b[ob]});
      const double more_m2 = both_m2 - a_alone.wrong_m2[oa] - only_b[ob] + a_alone.none_m2;
      matters = matters || std::abs(more_m2) > nothing_m2;
      made.wrong_m2.push_back(more_m2);
    }
  }
  if (!matters) return std::nullopt;
  return made;
}

SelectionProblem FieldOptions::problem(double length_weight, double area_weight) const {
  SelectionProblem made{.crowds = {},
                        .interplays = {},
                        .straight_m = 0,
                        .planned_m2 = 0,
                        .length_weight = length_weight,
                        .area_weight = area_weight};
  for (const PassM& pass : passes_) {
    made.straight_m += pass.length_m();
    made.planned_m2 += pass.length_m() * pass.width_m;
  }
  std::vector<Alone> by_itself;
  for (std::size_t c = 0; c < crowds_.size(); ++c) {
    const double half_m = passes_[crowds_[c].pass].width_m / 2;
    const Alone& alone_here = by_itself.emplace_back(alone(c));
    std::vector<OptionCost>& costs = made.crowds.emplace_back();
    for (std::size_t o = 0; o < crowds_[c].crowd.options.size(); ++o) {
      const CrowdOption& option = crowds_[c].crowd.options[o];
      double wrong = alone_here.wrong_m2[o] - alone_here.none_m2;
      if (option.conduct == Conduct::sprayed) wrong += backswept_of(option.curve, half_m);
      costs.push_back({option.extra_m, wrong});
    }
  }
  for (std::size_t a = 0; a < crowds_.size(); ++a) {
    for (std::size_t b = a + 1; b < crowds_.size(); ++b) {
      if (!may_interplay(a, b)) continue;
      if (auto shared = interplay(a, by_itself[a], b))
        made.interplays.push_back(std::move(*shared));
    }
  }
  return made;
}

std::vector<FootprintM> FieldOptions::flown(std::size_t pass, const Selection& chosen) const {
  std::vector<Taken> taken;
  for (std::size_t c = 0; c < crowds_.size(); ++c) {
    if (crowds_[c].pass == pass) taken.push_back({c, chosen[c]});
  }
  return footprints(pass, taken);
}

std::vector<FootprintM> FieldOptions::straight() const {
  std::vector<FootprintM> made;
  for (const PassM& pass : passes_) made.push_back({{pass.a, pass.b}, pass.width_m / 2});
  return made;
}

double FieldOptions::backswept_m2(const Selection& chosen) const {
  double sum = 0;
  for (std::size_t c = 0; c < crowds_.size(); ++c) {
    const CrowdOption& option = crowds_[c].crowd.options[chosen[c]];
    if (option.conduct != Conduct::sprayed) continue;
    sum += backswept_of(option.curve, passes_[crowds_[c].pass].width_m / 2);
  }
  return sum;
}

}  // namespace furrow::planner
