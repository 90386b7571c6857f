#include "planner/avoidance/taut.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow::planner {
namespace {

constexpr double rounding_m = 1e-9;

// A circle with the sense in which the string runs along it.
struct Wheel {
  PointM center;
  double radius_m;
  double sense;  // +1 turns left
};

// A line that touches two wheels.
struct Tangent {
  double heading_rad, length_m;
};

std::optional<Tangent> tangent(const Wheel& a, const Wheel& b) {
  const PointM way = b.center - a.center;
  const double across_m = b.sense * b.radius_m - a.sense * a.radius_m;
  const double squared = dot(way, way) - across_m * across_m;
  if (squared < -rounding_m * (1 + dot(way, way))) return std::nullopt;
  const double along_m = std::sqrt(std::max(0.0, squared));
  return Tangent{std::atan2(way.y, way.x) - std::atan2(across_m, along_m), along_m};
}

// How far the string turns along wheel i, negative where it would lift off. Around one circle it
// may wind by three quarters of a turn; along several it lifts off by up to nearly half a turn, at
// a corner of a house that it came to too early.
double sweep_rad(const std::vector<Wheel>& wheels, std::size_t i, double in_rad, double out_rad) {
  const double sense = wheels[i].sense;
  const bool is_one_of_several = (i > 0 && wheels[i - 1].sense == sense) ||
                                 (i + 1 < wheels.size() && wheels[i + 1].sense == sense);
  const double most_lift_rad = (is_one_of_several ? 0.9 : 0.5) * std::numbers::pi;
  const double turn = wrapped_rad(sense * (out_rad - in_rad));
  return turn < -most_lift_rad ? turn + 2 * std::numbers::pi : turn;
}

// The wheel, not one of the ends, that must go before the string can be tight: one inside its
// neighbour, or the one from which the string lifts off most. Nothing: it is tight.
struct Step {
  std::optional<std::size_t> drop;
  bool is_blocked = false;
};

Step next_step(const std::vector<Wheel>& wheels) {
  std::vector<double> headings{0.0};
  for (std::size_t i = 0; i + 1 < wheels.size(); ++i) {
    const auto line = tangent(wheels[i], wheels[i + 1]);
    if (!line) {
      if (wheels[i].sense != wheels[i + 1].sense) return {std::nullopt, true};
      const std::size_t inner = wheels[i].radius_m < wheels[i + 1].radius_m ? i : i + 1;
      const bool is_end = inner == 0 || inner + 1 == wheels.size();
      return is_end ? Step{std::nullopt, true} : Step{inner};
    }
    headings.push_back(line->heading_rad);
  }
  headings.push_back(0.0);
  Step worst;
  double least = -1e-9;
  for (std::size_t i = 1; i + 1 < wheels.size(); ++i) {
    const double sweep = sweep_rad(wheels, i, headings[i], headings[i + 1]);
    if (sweep < least) {
      least = sweep;
      worst.drop = i;
    }
  }
  return worst;
}

CurveM pulled(const std::vector<Wheel>& wheels, double from_m) {
  CurveM curve{{{from_m, 0}, 0}, {}};
  double heading = 0;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const bool is_last = i + 1 == wheels.size();
    const Tangent line = is_last ? Tangent{0, 0} : *tangent(wheels[i], wheels[i + 1]);
    const double turn = std::max(0.0, sweep_rad(wheels, i, heading, line.heading_rad));
    curve.bends.push_back({wheels[i].sense / wheels[i].radius_m, turn * wheels[i].radius_m});
    if (line.length_m > rounding_m) curve.bends.push_back({0, line.length_m});
    heading = line.heading_rad;
  }
  return curve;
}

}  // namespace

AlongLine detour_span(const PassedCircle& circle, double turn_m) {
  const double across_m = turn_m - sign(circle.side) * circle.center.y;
  const double centers_m = turn_m + circle.radius_m;
  if (across_m >= centers_m) return {INFINITY, -INFINITY};
  // Far on the side to be passed on: a turn circle does not reach so high.
  const double reach_m =
      across_m <= -centers_m ? 0 : std::sqrt(centers_m * centers_m - across_m * across_m);
  return {circle.center.x - reach_m, circle.center.x + reach_m};
}

std::optional<CurveM> taut_curve(std::vector<PassedCircle> circles, double turn_m) {
  std::erase_if(circles, [&](const PassedCircle& c) {
    const AlongLine span = detour_span(c, turn_m);
    return span.low_m > span.high_m;
  });
  if (circles.empty()) return std::nullopt;
  std::stable_sort(circles.begin(), circles.end(),
                   [](const auto& a, const auto& b) { return a.center.x < b.center.x; });
  const auto first = std::min_element(circles.begin(), circles.end(), [&](auto& a, auto& b) {
    return detour_span(a, turn_m).low_m < detour_span(b, turn_m).low_m;
  });
  const auto last = std::max_element(circles.begin(), circles.end(), [&](auto& a, auto& b) {
    return detour_span(a, turn_m).high_m < detour_span(b, turn_m).high_m;
  });
  const double from_m = detour_span(*first, turn_m).low_m;
  const double to_m = detour_span(*last, turn_m).high_m;

  std::vector<Wheel> wheels{{{from_m, sign(first->side) * turn_m}, turn_m, sign(first->side)}};
  for (const PassedCircle& c : circles) wheels.push_back({c.center, c.radius_m, -sign(c.side)});
  wheels.push_back({{to_m, sign(last->side) * turn_m}, turn_m, sign(last->side)});
  for (;;) {
    const Step step = next_step(wheels);
    if (step.is_blocked) return std::nullopt;
    if (!step.drop) break;
    wheels.erase(wheels.begin() + static_cast<std::ptrdiff_t>(*step.drop));
  }
  CurveM curve = pulled(wheels, from_m);
  const PoseM end = end_pose(curve);
  const bool is_back = norm(end.at - PointM{to_m, 0}) <= 1e-6 * (1 + length_m(curve)) &&
                       std::abs(wrapped_rad(end.heading_rad)) <= 1e-6;
  if (!is_back) return std::nullopt;
  return curve;
}

}  // namespace furrow::planner
