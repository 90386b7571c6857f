#include "scheduler/lower_bound.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::scheduler {
namespace {

constexpr double tolerance_s = 0.05;

/// The largest time, within the tolerance, that `is_too_short` holds for; it holds below some time
/// and not above.
template <class Question>
double last_short_s(Question is_too_short) {
  double low_s = 0.0, high_s = 1.0;
  for (; is_too_short(high_s); high_s *= 2.0) low_s = high_s;
  while (high_s - low_s > tolerance_s) {
    const double middle_s = 0.5 * (low_s + high_s);
    (is_too_short(middle_s) ? low_s : high_s) = middle_s;
  }
  return low_s;
}

/// Whether as many aircraft as `count`, all at `pace`, leave strips over at `finish_s`.
bool leaves_strips(const planner::Route& route, const RouteLengths& lengths, const Pace& pace,
                   std::size_t count, double finish_s) {
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < count && next < route.strips.size(); ++i) {
    GrowingShare growing{route, lengths, pace, next};
    while (growing.can_grow() && growing.grow() <= finish_s) ++next;
  }
  return next < route.strips.size();
}

/// The least that an aircraft needs, whatever it sprays.
struct LeastCosts {
  double out_s, spray_mps, tank_m, return_s, fill_s_per_m;
};

LeastCosts least_costs(const planner::Route& route, const RouteLengths& lengths,
                       const Vehicle& vehicle, std::span<const Station> stations) {
  const Pace fastest = fastest_pace(route, {&vehicle, 1}, stations, lengths.nearest_m);
  const double nearest_m = *std::min_element(lengths.nearest_m.begin(), lengths.nearest_m.end());
  return {.out_s = *std::min_element(fastest.out_s.begin(), fastest.out_s.end()),
          .spray_mps = fastest.spray_mps,
          .tank_m = fastest.tank_m,
          .return_s = fastest.fill_base_s + 2.0 * nearest_m / fastest.ferry_mps,
          .fill_s_per_m = fastest.fill_s_per_m};
}

/// The longest distance sprayed by `finish_s`: whole tanks, each but the first after a return, then
/// part of one.
double distance_by_m(const LeastCosts& c, double finish_s) {
  const double left_s = finish_s - c.out_s;
  if (left_s <= 0.0) return 0.0;
  const double first_s = c.tank_m / c.spray_mps;
  if (left_s <= first_s) return left_s * c.spray_mps;
  const double s_per_m = 1.0 / c.spray_mps + c.fill_s_per_m;
  const double tank_s = c.return_s + c.tank_m * s_per_m;
  const double tanks = std::floor((left_s - first_s) / tank_s);
  const double rest_s = left_s - first_s - tanks * tank_s - c.return_s;
  return (1.0 + tanks) * c.tank_m + std::max(0.0, rest_s) / s_per_m;
}

}  // namespace

double makespan_bound_s(const planner::Route& route, const RouteLengths& lengths,
                        std::span<const Vehicle> vehicles, std::span<const Station> stations) {
  const Pace fastest = fastest_pace(route, vehicles, stations, lengths.nearest_m);
  const double by_share_s = last_short_s([&](double finish_s) {
    return leaves_strips(route, lengths, fastest, vehicles.size(), finish_s);
  });
  std::vector<LeastCosts> costs;
  for (const Vehicle& v : vehicles) costs.push_back(least_costs(route, lengths, v, stations));
  const double cuts = static_cast<double>(std::min(vehicles.size(), route.strips.size())) - 1.0;
  const double needed_m = lengths.spray_m.back() - cuts * route.cell.base();
  const double by_work_s = last_short_s([&](double finish_s) {
    double sprayed_m = 0.0;
    for (const LeastCosts& c : costs) sprayed_m += distance_by_m(c, finish_s);
    return sprayed_m < needed_m;
  });
  return std::max(by_share_s, by_work_s);
}

}  // namespace furrow::scheduler
