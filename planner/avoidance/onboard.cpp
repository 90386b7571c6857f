#include "planner/avoidance/onboard.hpp"

#include "core/require.hpp"
#include "planner/avoidance/field_options.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

constexpr int most_crowds = 100;  // on one line
constexpr double on_line_m = 1e-6, on_line_rad = 1e-6, same_place_m = 1e-6;

PointM plane(FieldPoint p) { return {p.x.base(), p.y.base()}; }

// Onto the line, one to four turn radii ahead: the first way that is no loop and is free.
std::optional<CurveM> joined(const OnboardLine& line, PointM foot, RowFrame frame, const Room& room,
                             Length turn_radius) {
  const double heading = std::atan2(frame.sine, frame.cosine);
  for (int radii = 1; radii <= 4; ++radii) {
    const double ahead_m = radii * turn_radius.base();
    const PointM at = foot + frame.from({ahead_m, 0});
    const CurveM curve = dubins_curve(line.pose, {at_m(at.x, at.y), heading}, turn_radius);
    const double straight_m = norm(at - plane(line.pose.at));
    if (length_m(curve) < 1.5 * straight_m && room.is_free(tangent_path(curve, corner_rad))) {
      return curve;
    }
  }
  return std::nullopt;
}

// How far the ways around reach beside the pass.
double reach_m(const Crowd& crowd, const PassM& pass) {
  const RowFrame frame = RowFrame::along(pass.b - pass.a);
  double most_m = 0;
  for (const CrowdOption& option : crowd.options) {
    if (option.conduct == Conduct::blocked) continue;
    for (const PointM p : tangent_path(option.curve, corner_rad)) {
      most_m = std::max(most_m, std::abs(frame.to(p - pass.a).y));
    }
  }
  return most_m;
}

// The pass and its neighbours as they would be planned, as far as a way around may spray.
std::vector<PassM> with_neighbours(const PassM& pass, double aside_m) {
  constexpr double most = 20;  // on each side
  const double count = std::min(most, std::floor(aside_m / pass.width_m + 1));
  const RowFrame frame = RowFrame::along(pass.b - pass.a);
  std::vector<PassM> all{pass};
  for (double i = 1; i <= count; ++i) {
    const PointM aside = frame.from({0, i * pass.width_m});
    all.push_back({pass.a + aside, pass.b + aside, pass.width_m});
    all.push_back({pass.a - aside, pass.b - aside, pass.width_m});
  }
  return all;
}

const CrowdOption* best_option(const Crowd& crowd, const PassM& pass, const Room& room,
                               DetourWeights weights) {
  const std::vector<PassM> passes = with_neighbours(pass, reach_m(crowd, pass));
  const CrowdOption* best = nullptr;
  double least = INFINITY;
  for (const CrowdOption& option : crowd.options) {
    if (option.conduct == Conduct::blocked) continue;
    const double length = option.extra_m / pass.length_m();
    if (weights.length * length >= least) continue;
    const double area = wrong_alone_m2(passes, option, room) / (pass.length_m() * pass.width_m);
    const double cost = weights.length * length + weights.area * area;
    if (cost < least) {
      least = cost;
      best = &option;
    }
  }
  return best;
}

}  // namespace

Expected<OnboardDetour, NoDetour> onboard_detour(const OnboardLine& line, const Room& room,
                                                 Length turn_radius, DetourWeights weights) {
  const PointM from = plane(line.from), to = plane(line.to), here = plane(line.pose.at);
  require(norm(to - from) > 0 && line.swath > Length{}, "a line has length and width");
  const RowFrame frame = RowFrame::along(to - from);
  const PointM seen = frame.to(here - from);
  PointM foot = from + frame.from({seen.x, 0});
  const double left_m = norm(to - from) - seen.x;
  if (left_m <= on_line_m || room.is_clear({foot, to})) {
    return Unexpected{NoDetour::nothing_ahead};
  }

  OnboardDetour made{.way = {line.pose.at}, .length = {}, .side = Side::left};
  const auto go_on = [&](PointM p) {
    const FieldPoint at = at_m(p.x, p.y);
    if (distance(made.way.back(), at) >= metres(same_place_m)) made.way.push_back(at);
  };
  const double askew = wrapped_rad(line.pose.heading_rad - std::atan2(frame.sine, frame.cosine));
  if (std::abs(seen.y) > on_line_m || std::abs(askew) > on_line_rad) {
    const auto joint = joined(line, foot, frame, room, turn_radius);
    if (!joint) return Unexpected{NoDetour::too_late};
    for (const PointM p : tangent_path(*joint, corner_rad)) go_on(p);
    made.length += metres(length_m(*joint));
    foot = end_pose(*joint).at;
  }
  const PassM pass{foot, to, line.swath.base()};
  if (dot(to - foot, to - from) <= 0) return Unexpected{NoDetour::no_room};
  const auto targets = targets_of(pass, room);
  if (targets.empty()) return Unexpected{NoDetour::nothing_ahead};
  const Crowd crowd = crowds_of(pass, targets, room, turn_radius.base()).front();
  const CrowdOption* best = best_option(crowd, pass, room, weights);
  if (!best) {
    const bool is_late = crowd.options.front().low_m <= on_line_m;
    return Unexpected{is_late ? NoDetour::too_late : NoDetour::no_room};
  }
  const PathM around = tangent_path(best->curve, corner_rad);
  go_on(around.front());
  made.leaves = made.way.size() - 1;
  for (const PointM p : around) go_on(p);
  made.sprays = best->conduct == Conduct::sprayed;
  made.length += metres(best->low_m + length_m(best->curve));
  made.side = best->sides.front();
  return made;
}

std::optional<OnboardWay> onboard_way(FieldPoint from, FieldPoint to, Length swath,
                                      const Room& room, Length turn_radius, DetourWeights weights) {
  const PointM ahead = plane(to) - plane(from);
  if (norm(ahead) < same_place_m) return std::nullopt;
  OnboardLine line{{from, std::atan2(ahead.y, ahead.x)}, from, to, swath};
  OnboardWay made;
  for (int i = 0; i < most_crowds; ++i) {
    const auto detour = onboard_detour(line, room, turn_radius, weights);
    if (!detour && detour.error() == NoDetour::nothing_ahead) return made;
    if (!detour || detour->way.size() < 2) return std::nullopt;  // or it leads nowhere
    for (std::size_t k = 1; k < detour->way.size(); ++k) {
      made.bends.push_back({detour->way[k], detour->sprays || k <= detour->leaves});
    }
    made.longer += detour->length - distance(line.pose.at, detour->way.back());
    if (!detour->sprays) {
      made.dry += detour->length - distance(line.pose.at, detour->way[detour->leaves]);
    }
    line.pose.at = detour->way.back();
  }
  return std::nullopt;
}

}  // namespace furrow::planner
