#include "agents/guidance/pilot.hpp"

#include "agents/control_clock.hpp"

#include <algorithm>

namespace furrow::agents {
namespace {

constexpr double stiffness_per_s2 = 4.0;  // 2 rad/s, critically damped: well below 10 Hz control
constexpr double damping_per_s = 4.0;
constexpr double tolerated_lag_m = 0.5;  // the pace waits for an aircraft further behind

constexpr double alike = 1e-9;  // rounding, in m, 1/m and (m/s)2

bool begin_alike(const Segment& a, const Segment& b) {
  return norm(a.from - b.from) < alike && norm(a.ahead - b.ahead) < alike &&
         std::abs(a.curvature_per_m - b.curvature_per_m) < alike;
}

Path resting_at(Xy place) {
  Path path{place, {.acceleration_mps2 = 1.0, .corner_cut_m = 0.0, .min_radius_m = 0.0}};
  path.finish();
  return path;
}

}  // namespace

Pilot::Pilot(double planned_mps2, double limit_mps2)
    : planned_{planned_mps2}, limit_{limit_mps2}, path_{resting_at({})}, pace_{planned_} {}

void Pilot::follow(Path path) {
  path_ = std::move(path);
  pace_ = Pace{planned_};
  deviation_ = {};
  ahead_ = path_.segments().front().ahead;
}

bool Pilot::leads_on(const Path& path) const {
  const auto &flown = path_.segments(), &next = path.segments();
  const std::size_t here = pace_.segment();
  if (here >= next.size() || pace_.along_m() > next[here].end_m()) return false;
  for (std::size_t i = 0; i < here; ++i) {
    if (!begin_alike(flown[i], next[i]) || std::abs(flown[i].length_m - next[i].length_m) > alike)
      return false;
  }
  if (!begin_alike(flown[here], next[here])) return false;
  const double speed = pace_.speed_mps();
  const double from_m = pace_.along_m() + speed * control_period_s;
  return std::all_of(
      next.begin() + static_cast<std::ptrdiff_t>(here) + 1, next.end(), [&](const Segment& s) {
        return speed * speed <=
               s.entry_mps * s.entry_mps + 2.0 * planned_ * (s.start_m - from_m) + alike;
      });
}

void Pilot::redirect(Path path) { path_ = std::move(path); }

void Pilot::observe(Xy estimate_m) { deviation_ = deviation(segment(), estimate_m); }

Xy Pilot::steer(double stop_m, Xy estimate_m, Xy velocity_mps) {
  observe(estimate_m);
  const double lag = pace_.along_m() - deviation_.along_m;
  const Pose now = pose(segment(), pace_.along_m());
  const double speed = pace_.speed_mps();
  pace_.advance(path_, stop_m, std::clamp(1.0 - (lag - tolerated_lag_m), 0.0, 1.0));

  const Xy right = right_of(now.ahead);
  const Xy corrected =
      (stiffness_per_s2 * lag + damping_per_s * (speed - dot(velocity_mps, now.ahead))) *
          now.ahead -
      (stiffness_per_s2 * deviation_.cross_m + damping_per_s * dot(velocity_mps, right)) * right;
  // What takes the velocity of the pace to the next one, along and around a corner.
  ahead_ = pose(segment(), pace_.along_m()).ahead;
  const Xy led = (1.0 / control_period_s) * (pace_.speed_mps() * ahead_ - speed * now.ahead);
  return limited(led + corrected, limit_);
}

}  // namespace furrow::agents
