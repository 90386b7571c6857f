#include "scheduler/leg_times.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace furrow::scheduler {
namespace {

constexpr double unlimited_mps = std::numeric_limits<double>::infinity();

}  // namespace

void Legs::add(FieldPoint to, Speed limit, Corner corner) {
  const double length_m = distance(at_, to).base();
  if (length_m < same_place_m) {
    if (!legs_.empty()) legs_.back().corner = std::max(legs_.back().corner, corner);
    return;
  }
  legs_.push_back({.x = (to - at_).x.base() / length_m,
                   .y = (to - at_).y.base() / length_m,
                   .length_m = length_m,
                   .limit_mps = limit.base(),
                   .corner = corner});
  at_ = to;
}

// Flies one stretch after another.
class LegTimes::Clock {
 public:
  explicit Clock(double acceleration_mps2) : acceleration_{acceleration_mps2} {}

  double now_s() const { return now_s_; }
  double speed_mps() const { return speed_mps_; }

  /// @param wanted_mps  Speed at its end at most.
  /// @return  The time taken [s].
  double fly(const Stretch& s, double wanted_mps) {
    const double exit_mps =
        std::min(wanted_mps, std::sqrt(speed_mps_ * speed_mps_ + 2.0 * acceleration_ * s.length_m));
    const double took_s = leg_time_s(s.length_m, s.limit_mps, speed_mps_, exit_mps, acceleration_);
    now_s_ += took_s;
    speed_mps_ = exit_mps;
    return took_s;
  }
  void skip(double time_s, double speed_mps) {
    now_s_ += time_s;
    speed_mps_ = speed_mps;
  }

 private:
  double acceleration_, now_s_ = 0.0, speed_mps_ = 0.0;
};

LegTimes::LegTimes(const Vehicle& vehicle, std::vector<Leg> way)
    : acceleration_mps2_{planned_acceleration(vehicle).base()},
      cut_m_{0.5 * vehicle.swath.base()},
      least_radius_m_{vehicle.min_turn_radius.base()},
      way_{std::move(way)} {
  stretches_ = stretches_of(way_, 0.0, 0.0);
  plan_entries(stretches_, 0.0, unlimited_mps);
  Clock clock{acceleration_mps2_};
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    at_s_.push_back(clock.now_s());
    entered_mps_.push_back(clock.speed_mps());
    clock.fly(stretches_[i], i + 1 < stretches_.size() ? stretches_[i + 1].entry_mps : 0.0);
  }
}

LegTimes::Turn LegTimes::turn(const Leg& in, const Leg& out) const {
  const double limit_mps = std::min(in.limit_mps, out.limit_mps);
  const double angle =
      std::abs(std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y));
  if (angle <= straight_rad) return {0.0, {0.0, limit_mps}};
  const auto [cut_m, radius_m] =
      corner_arc(in.corner, angle, std::min(in.length_m, out.length_m), cut_m_, least_radius_m_);
  if (radius_m == 0.0) return {0.0, {0.0, 0.0}};
  const double turning_mps = arc_speed_mps(acceleration_mps2_, radius_m);
  return {cut_m, {radius_m * angle, std::min(limit_mps, turning_mps)}};
}

// What corners with other legs take of the first and the last comes with it.
LegTimes::Stretches LegTimes::stretches_of(const std::vector<Leg>& legs, double before_m,
                                           double after_m) const {
  Stretches made;
  made.reserve(2 * legs.size());
  double taken_m = before_m;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const bool is_last = i + 1 == legs.size();
    const Turn next = is_last ? Turn{after_m, {}} : turn(legs[i], legs[i + 1]);
    made.push_back({std::max(0.0, legs[i].length_m - taken_m - next.cut_m), legs[i].limit_mps});
    if (!is_last) made.push_back(next.arc);
    taken_m = next.cut_m;
  }
  return made;
}

double LegTimes::plan_entry(Stretch& s, double exit_mps, double before_mps) const {
  const double brakes_mps = std::sqrt(exit_mps * exit_mps + 2.0 * acceleration_mps2_ * s.length_m);
  return s.entry_mps = std::min({s.limit_mps, brakes_mps, before_mps});
}

// From the end backwards: no faster than what the next can be met from.
double LegTimes::plan_entries(Stretches& stretches, double exit_mps, double before_mps) const {
  for (std::size_t i = stretches.size(); i-- > 0;) {
    exit_mps = plan_entry(stretches[i], exit_mps, i > 0 ? stretches[i - 1].limit_mps : before_mps);
  }
  return exit_mps;
}

SortieTimes LegTimes::finished(Clock clock, const Stretches& last, std::size_t sprayed_legs) {
  double sprayed_s = 0.0;
  for (std::size_t i = 0; i < last.size(); ++i) {
    const double before_s = clock.now_s();
    const double took_s = clock.fly(last[i], i + 1 < last.size() ? last[i + 1].entry_mps : 0.0);
    // Stretches 2 i and 2 i + 1 are leg i and the corner after it.
    if (i + 1 == 2 * sprayed_legs) sprayed_s = before_s + 0.5 * took_s;
    if (i + 2 == 2 * sprayed_legs && i + 1 == last.size()) sprayed_s = clock.now_s();
  }
  return {.until_sprayed_s = sprayed_s, .home_s = clock.now_s() - sprayed_s};
}

SortieTimes LegTimes::of(const std::vector<Leg>& legs, std::size_t sprayed_legs) const {
  Stretches all = stretches_of(legs, 0.0, 0.0);
  plan_entries(all, 0.0, unlimited_mps);
  return finished(Clock{acceleration_mps2_}, all, sprayed_legs);
}

SortieTimes LegTimes::of(const std::vector<Leg>& head, Shared shared, const std::vector<Leg>& tail,
                         std::size_t sprayed_legs) const {
  require(shared.first < shared.last && shared.last < way_.size() && !head.empty() && !tail.empty(),
          "legs are shared between a flight's own");
  const std::size_t begin = 2 * shared.first + 1, end = 2 * shared.last;
  const auto cut_m = [&](std::size_t leg) { return turn(way_[leg], way_[leg + 1]).cut_m; };
  Stretches before = stretches_of(head, 0.0, cut_m(shared.first));
  Stretches after = stretches_of(tail, cut_m(shared.last - 1), 0.0);

  // The stretches of the way where it brakes for its own end, the last first.
  Stretches braked;
  std::size_t own = end;
  double exit_mps = plan_entries(after, 0.0, stretches_[end - 1].limit_mps);
  for (; own > begin && exit_mps != stretches_[own].entry_mps; --own) {
    braked.push_back(stretches_[own - 1]);
    exit_mps = plan_entry(braked.back(), exit_mps, stretches_[own - 2].limit_mps);
  }
  const double joins_mps = own == begin ? exit_mps : stretches_[begin].entry_mps;
  plan_entries(before, joins_mps, unlimited_mps);

  Clock clock{acceleration_mps2_};
  for (std::size_t i = 0; i < before.size(); ++i) {
    clock.fly(before[i], i + 1 < before.size() ? before[i + 1].entry_mps : joins_mps);
  }
  std::size_t at = begin;
  for (; at < own && clock.speed_mps() != entered_mps_[at]; ++at) {
    clock.fly(stretches_[at], stretches_[at + 1].entry_mps);
  }
  if (at < own) clock.skip(at_s_[own] - at_s_[at], entered_mps_[own]);
  for (std::size_t i = braked.size(); i-- > 0;) {
    clock.fly(braked[i], i > 0 ? braked[i - 1].entry_mps : after.front().entry_mps);
  }
  return finished(clock, after, sprayed_legs);
}

}  // namespace furrow::scheduler
