#include "planner/avoidance/crowd.hpp"

#include "core/require.hpp"
#include "planner/avoidance/taut.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace furrow::planner {
namespace {

constexpr std::size_t most_free_targets = 6;
constexpr std::size_t most_options = 8;
constexpr int most_rounds = 8;  // of taking in neighbours
constexpr double rounding_m = 1e-9;

PassedCircle passed(PointM center, double radius_m, Side side, double turn_m) {
  const Beside circle = replaced({metres(center.y), metres(radius_m)}, metres(turn_m), side);
  return {{center.x, circle.left.base()}, circle.radius.base(), side};
}

// A pass as the x-axis, obstacles seen from it.
class Line {
 public:
  Line(const PassM& pass, const Room& room, double turn_m)
      : pass_{pass}, room_{room}, turn_m_{turn_m}, frame_{RowFrame::along(pass.b - pass.a)} {}

  double length_m() const { return pass_.length_m(); }
  PointM local(PointM p) const { return frame_.to(p - pass_.a); }

  std::vector<PassedCircle> circles(const TargetM& target, Side side) const {
    std::vector<PassedCircle> made;
    for (const CircleM& c : target.circles) {
      made.push_back(passed(local(c.center), c.radius_m, side, turn_m_));
    }
    return made;
  }

  // Of one target alone.
  AlongLine span(const TargetM& target, Side side) const {
    AlongLine all{INFINITY, -INFINITY};
    for (const PassedCircle& c : circles(target, side)) {
      const AlongLine one = detour_span(c, turn_m_);
      all = {std::min(all.low_m, one.low_m), std::max(all.high_m, one.high_m)};
    }
    return all;
  }
  AlongLine span(const TargetM& target) const {
    const AlongLine l = span(target, Side::left), r = span(target, Side::right);
    return {std::min(l.low_m, r.low_m), std::max(l.high_m, r.high_m)};
  }

  CurveM placed(CurveM curve) const {
    curve.start.at = pass_.a + frame_.from(curve.start.at);
    curve.start.heading_rad += std::atan2(frame_.sine, frame_.cosine);
    return curve;
  }

  // The way past `targets`, and past what else it would meet.
  std::optional<CrowdOption> around(const std::vector<TargetM>& targets,
                                    const std::vector<Side>& sides) const {
    std::vector<PassedCircle> around;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      for (const PassedCircle& c : circles(targets[i], sides[i])) around.push_back(c);
    }
    std::vector<std::size_t> taken;
    for (int round = 0; round < most_rounds; ++round) {
      const auto curve = taut_curve(around, turn_m_);
      if (!curve) return std::nullopt;
      const double low_m = curve->start.at.x, high_m = end_pose(*curve).at.x;
      if (low_m < -rounding_m || high_m > length_m() + rounding_m) return std::nullopt;
      const CurveM there = placed(*curve);
      const PathM path = tangent_path(there, corner_rad);
      const auto met = room_.entered(path);
      if (met.empty()) {
        const AlongLine reach = reach_of(targets);
        const bool is_clear =
            room_.is_clear_of_barriers(path) &&
            room_.is_clear_of_barriers({along(std::min(low_m, reach.low_m)), along(low_m)}) &&
            room_.is_clear_of_barriers({along(high_m), along(std::max(high_m, reach.high_m))});
        if (!is_clear || !room_.is_inside(path)) return std::nullopt;
        return CrowdOption{Conduct::sprayed, sides, low_m,
                           high_m,           there, planner::length_m(there) - (high_m - low_m)};
      }
      for (const std::size_t i : met) {
        if (std::find(taken.begin(), taken.end(), i) != taken.end()) return std::nullopt;
        taken.push_back(i);
        const CircleM& c = room_.circles()[i];
        around.push_back(
            passed(local(c.center), c.radius_m, side_beside(around, local(c.center).x), turn_m_));
      }
    }
    return std::nullopt;
  }

  // The pass ends where the last turn away is possible, and begins again after the first turn back.
  CrowdOption blocked(const std::vector<TargetM>& targets) const {
    AlongLine l{INFINITY, -INFINITY}, r = l;
    for (const TargetM& t : targets) {
      const AlongLine left = span(t, Side::left), right = span(t, Side::right);
      l = {std::min(l.low_m, left.low_m), std::max(l.high_m, left.high_m)};
      r = {std::min(r.low_m, right.low_m), std::max(r.high_m, right.high_m)};
    }
    const double low_m = std::clamp(std::max(l.low_m, r.low_m), 0.0, length_m());
    const double high_m = std::clamp(std::min(l.high_m, r.high_m), low_m, length_m());
    const AlongLine reach = reach_of(targets);
    return {Conduct::blocked,
            {},
            clear_until(std::min(low_m, reach.low_m), low_m),
            clear_until(std::max(high_m, reach.high_m), high_m),
            {},
            0.0};
  }

 private:
  PointM along(double at_m) const { return pass_.a + (at_m / length_m()) * (pass_.b - pass_.a); }

  // Beyond this the line is clear of `targets`.
  AlongLine reach_of(const std::vector<TargetM>& targets) const {
    AlongLine reach{INFINITY, -INFINITY};
    for (const TargetM& t : targets) {
      for (const CircleM& c : t.circles) {
        const double at_m = local(c.center).x;
        reach = {std::min(reach.low_m, at_m - c.radius_m),
                 std::max(reach.high_m, at_m + c.radius_m)};
      }
    }
    return {std::max(0.0, reach.low_m), std::min(length_m(), reach.high_m)};
  }

  // How far from a clear place towards another the line is clear: beside an oblique edge it is too
  // near for longer than at the edge's corners.
  double clear_until(double from_m, double to_m) const {
    constexpr double step_m = 0.1;
    const double way_m = to_m - from_m, steps = std::ceil(std::abs(way_m) / step_m);
    double clear_m = from_m;
    for (double k = 1; k <= steps; ++k) {
      const double next_m = from_m + k / steps * way_m;
      if (!room_.is_clear({along(clear_m), along(next_m)})) break;
      clear_m = next_m;
    }
    return clear_m;
  }

  static Side side_beside(const std::vector<PassedCircle>& around, double x) {
    return std::min_element(around.begin(), around.end(),
                            [x](const PassedCircle& a, const PassedCircle& b) {
                              return std::abs(a.center.x - x) < std::abs(b.center.x - x);
                            })
        ->side;
  }

  const PassM& pass_;
  const Room& room_;
  double turn_m_;
  RowFrame frame_;
};

// Choices of sides to try: all, or those that change sides at most once.
std::vector<std::vector<Side>> side_choices(std::size_t targets) {
  std::vector<std::vector<Side>> choices;
  if (targets <= most_free_targets) {
    for (std::size_t bits = 0; bits < (std::size_t{1} << targets); ++bits) {
      std::vector<Side> sides;
      for (std::size_t i = 0; i < targets; ++i) {
        sides.push_back((bits >> i & 1) == 1 ? Side::right : Side::left);
      }
      choices.push_back(std::move(sides));
    }
    return choices;
  }
  for (const Side first : {Side::left, Side::right}) {
    for (std::size_t change = 1; change <= targets; ++change) {
      std::vector<Side> sides(change, first);
      sides.resize(targets, opposite(first));
      choices.push_back(std::move(sides));
    }
  }
  return choices;
}

std::vector<CrowdOption> options_of(const Line& line, const std::vector<TargetM>& targets) {
  std::vector<CrowdOption> options;
  for (const auto& sides : side_choices(targets.size())) {
    if (auto option = line.around(targets, sides)) options.push_back(std::move(*option));
  }
  if (options.empty()) return {line.blocked(targets)};
  std::stable_sort(options.begin(), options.end(), [](const CrowdOption& a, const CrowdOption& b) {
    return a.extra_m < b.extra_m;
  });
  if (options.size() > most_options) options.resize(most_options);
  CrowdOption closed = options.front();
  closed.conduct = Conduct::closed;
  options.push_back(std::move(closed));
  return options;
}

AlongLine span_of(const std::vector<CrowdOption>& options) {
  AlongLine span{INFINITY, -INFINITY};
  for (const CrowdOption& o : options) {
    span = {std::min(span.low_m, o.low_m), std::max(span.high_m, o.high_m)};
  }
  return span;
}

}  // namespace

std::vector<TargetM> targets_of(const PassM& pass, const Room& room) {
  std::vector<TargetM> targets;
  for (const std::size_t i : room.circles_near(pass.a, pass.b, 0)) {
    targets.push_back({{room.circles()[i]}});
  }
  for (const BarrierM& barrier : room.barriers()) {
    if (Room{{}, {barrier}, {}}.is_clear_of_barriers({pass.a, pass.b})) continue;
    TargetM& target = targets.emplace_back();
    for (std::size_t i = 0; i < barrier.ring.size(); ++i) {
      const PointM a = barrier.ring[i], b = barrier.ring[(i + 1) % barrier.ring.size()];
      target.circles.push_back({a, barrier.clearance_m});
      // Where an edge crosses the line, either side has a corner of its own.
      const double at_a = cross(pass.b - pass.a, a - pass.a);
      const double at_b = cross(pass.b - pass.a, b - pass.a);
      if (at_a * at_b < 0) {
        target.circles.push_back({a + at_a / (at_a - at_b) * (b - a), barrier.clearance_m});
      }
    }
  }
  const auto place_m = [&](const TargetM& t) {
    return dot(t.circles.front().center - pass.a, pass.b - pass.a);
  };
  std::stable_sort(targets.begin(), targets.end(),
                   [&](const TargetM& a, const TargetM& b) { return place_m(a) < place_m(b); });
  return targets;
}

std::vector<Crowd> crowds_of(const PassM& pass, const std::vector<TargetM>& targets,
                             const Room& room, double turn_m) {
  require(turn_m > 0, "a detour has a turn radius");
  const Line line{pass, room, turn_m};
  struct Group {
    std::vector<std::size_t> members;
    AlongLine span;
    std::vector<CrowdOption> options;
  };
  std::vector<Group> groups;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    groups.push_back({{i}, line.span(targets[i]), {}});
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.span.low_m < b.span.low_m; });
  // Groups that meet are joined; what joins is planned anew and may meet the next.
  for (bool joined = true; joined;) {
    joined = false;
    std::vector<Group> next;
    for (Group& group : groups) {
      if (!next.empty() && group.span.low_m < next.back().span.high_m) {
        Group& last = next.back();
        last.members.insert(last.members.end(), group.members.begin(), group.members.end());
        last.span.low_m = std::min(last.span.low_m, group.span.low_m);
        last.span.high_m = std::max(last.span.high_m, group.span.high_m);
        last.options.clear();
        joined = true;
      } else {
        next.push_back(std::move(group));
      }
    }
    groups = std::move(next);
    if (joined) continue;
    for (Group& group : groups) {
      if (!group.options.empty()) continue;
      std::vector<TargetM> members;
      members.reserve(group.members.size());
      for (const std::size_t i : group.members) members.push_back(targets[i]);
      group.options = options_of(line, members);
      const AlongLine reach = span_of(group.options);
      if (reach.low_m < group.span.low_m || reach.high_m > group.span.high_m) joined = true;
      group.span = {std::min(reach.low_m, group.span.low_m),
                    std::max(reach.high_m, group.span.high_m)};
    }
  }
  std::vector<Crowd> crowds;
  crowds.reserve(groups.size());
  for (Group& group : groups) crowds.push_back({group.members, std::move(group.options)});
  return crowds;
}

}  // namespace furrow::planner
