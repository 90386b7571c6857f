#include "agents/guidance/pace.hpp"

#include "agents/control_clock.hpp"

#include <algorithm>

namespace furrow::agents {
namespace {

constexpr double arrived_m = 0.005;

}  // namespace

Pace::Pace(double acceleration_mps2) : limit_{acceleration_mps2} {}

double Pace::braking_m() const { return speed_ * (0.5 * speed_ / limit_ + control_period_s); }

// The speed after this period from which braking still ends at `exit_mps` after `rest_m`:
// (v0 + v1) / 2 dt + (v1^2 - exit^2) / (2 a) = rest.
double Pace::braking_to(double rest_m, double exit_mps) const {
  const double half = 0.5 * limit_ * control_period_s;
  const double square =
      half * half + exit_mps * exit_mps + 2.0 * limit_ * rest_m - 2.0 * half * speed_;
  return std::max(exit_mps, std::sqrt(std::max(0.0, square)) - half);
}

double Pace::next_speed(const Path& path, double stop_m, double eagerness) const {
  const auto& segments = path.segments();
  const double most_mps = speed_ + limit_ * control_period_s;
  const double reach = along_ + most_mps * (0.5 * most_mps / limit_ + control_period_s);
  double speed = std::min(most_mps, eagerness * segments[segment_].limit_mps);
  for (std::size_t i = segment_; i < segments.size() && segments[i].end_m() <= reach; ++i) {
    const double exit = i + 1 < segments.size() ? segments[i + 1].entry_mps : 0.0;
    speed = std::min(speed, braking_to(segments[i].end_m() - along_, exit));
  }
  if (stop_m <= reach) speed = std::min(speed, braking_to(stop_m - along_, 0.0));
  return std::max({speed, speed_ - limit_ * control_period_s, 0.0});
}

void Pace::advance(const Path& path, double stop_m, double eagerness) {
  const auto& segments = path.segments();
  // A corner turned on the spot is a segment of no length that begins where the aircraft stopped.
  while (segment_ + 1 < segments.size() && segments[segment_].end_m() <= along_ + arrived_m &&
         (speed_ < 0.1 || segments[segment_].end_m() <= along_)) {
    ++segment_;
  }
  const double rest = std::min(stop_m, path.length_m()) - along_;
  const double before = speed_;
  if (rest <= arrived_m && speed_ <= 0.1) {
    along_ += std::max(0.0, rest);
    speed_ = 0.0;
  } else {
    speed_ = next_speed(path, std::min(stop_m, path.length_m()), eagerness);
    along_ += 0.5 * control_period_s * (before + speed_);
  }
  while (segment_ + 1 < segments.size() && segments[segment_].end_m() < along_) ++segment_;
}

}  // namespace furrow::agents
