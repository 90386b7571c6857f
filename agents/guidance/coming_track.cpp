#include "agents/guidance/coming_track.hpp"

#include "agents/control_clock.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::agents {
namespace {

constexpr double even_m = 0.1;
constexpr int sampled_periods = 5;
constexpr int most_periods = 36'000;  // an hour

TimedPlace place(const Underway& now, const Path& path) {
  const Pose here = pose(path.segments()[now.pace.segment()], now.pace.along_m());
  return {now.at, field_point(here.at), now.altitude_m};
}

bool is_between(const TimedPlace& a, const TimedPlace& middle, const TimedPlace& b) {
  const double share = seconds(middle.at - a.at) / seconds(b.at - a.at);
  const auto off = [share](double x, double m, double y) { return std::lerp(x, y, share) - m; };
  return std::hypot(off(a.position.x.base(), middle.position.x.base(), b.position.x.base()),
                    off(a.position.y.base(), middle.position.y.base(), b.position.y.base()),
                    off(a.altitude_m, middle.altitude_m, b.altitude_m)) <= even_m;
}

// Leaves out what lies evenly between its neighbours.
std::vector<TimedPlace> thinned(const std::vector<TimedPlace>& all) {
  std::vector<TimedPlace> kept{all.front()};
  std::size_t last = 0;
  for (std::size_t i = 2; i < all.size(); ++i) {
    bool is_even = true;
    for (std::size_t k = last + 1; k < i && is_even; ++k) {
      is_even = is_between(all[last], all[k], all[i]);
    }
    if (is_even) continue;
    last = i - 1;
    kept.push_back(all[last]);
  }
  kept.push_back(all.back());
  return kept;
}

}  // namespace

double next_altitude_m(double altitude_m, double wanted_m, const planner::HeightRule& rule) {
  constexpr double in_hand = 1.2;
  const double most_m = in_hand * control_period_s * rule.climb.base();
  const double least_m = -in_hand * control_period_s * rule.descent.base();
  return altitude_m + std::clamp(wanted_m - altitude_m, least_m, most_m);
}

std::vector<TimedPlace> coming_track(Underway from, const Path& path, const HeightProfile& heights,
                                     const planner::HeightRule& rule, double to_m) {
  std::vector<TimedPlace> all{place(from, path)};
  for (int period = 1; period <= most_periods; ++period) {
    from.pace.advance(path, no_stop, 1.0);
    from.at += control_period;
    from.altitude_m =
        next_altitude_m(from.altitude_m, heights.altitude_m(from.pace.along_m()), rule);
    const bool arrives = from.pace.along_m() >= std::min(to_m, path.length_m());
    if (arrives || period % sampled_periods == 0) all.push_back(place(from, path));
    if (arrives) break;
  }
  return thinned(all);
}

}  // namespace furrow::agents
