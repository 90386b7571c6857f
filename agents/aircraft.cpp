#include "agents/aircraft.hpp"

#include "agents/control_clock.hpp"
#include "agents/guidance/coming_track.hpp"
#include "agents/text.hpp"
#include "core/random.hpp"

#include <algorithm>
#include <numbers>

namespace furrow::agents {
namespace {

constexpr std::uint64_t gusts = 0x67757374;     // "gust"
constexpr std::uint64_t receiver = 0x676e7373;  // "gnss"
constexpr double wind_filter = 0.2;             // per period: half a second

std::uint64_t own_seed(const AgentSettings& s, std::uint64_t purpose) {
  return seed_for(s.seed, {purpose, number(s.vehicle.id)});
}

// Time in the arc of a right-angled corner between strips.
double corner_s(const Vehicle& v) {
  const double radius_m = 0.5 * v.swath.base();
  const double speed =
      std::min(v.spray_speed.base(), arc_speed_mps(planned_acceleration_mps2(v), radius_m));
  return 0.5 * std::numbers::pi * radius_m / speed;
}

}  // namespace

std::optional<std::string> unholdable(const Vehicle& v) {
  constexpr double least_mps2 = 0.5, least_arc_s = 5 * control_period_s, round_off = 1e-9;
  const double swath_m = v.swath.base(), spray = v.spray_speed.base(), ferry = v.ferry_speed.base();
  const auto too_fast = [&](double speed, double most) {
    return "no autopilot of 10 Hz holds " + fixed(speed, 1) + " m/s on a swath of " +
           fixed(swath_m, 2) + " m, " + fixed(most, 1) + " m/s is the most";
  };
  const double most_spray = 0.5 * swath_m / control_period_s, most_ferry = 2.0 * most_spray;
  if (spray > most_spray + round_off) return too_fast(spray, most_spray);
  if (ferry > most_ferry + round_off) return too_fast(ferry, most_ferry);
  if (v.acceleration_limit.base() < least_mps2) {
    return "an acceleration of " + fixed(v.acceleration_limit.base(), 2) +
           " m/s2 does not hold it on its line, " + fixed(least_mps2, 2) + " m/s2 is the least";
  }
  const double arc_s = corner_s(v);
  if (arc_s < least_arc_s) {
    return "it turns a corner of half a swath of " + fixed(swath_m, 2) + " m in " +
           fixed(arc_s, 2) + " s, no autopilot of 10 Hz holds less than " + fixed(least_arc_s, 2) +
           " s";
  }
  return std::nullopt;
}

Aircraft::Aircraft(const AgentSettings& s)
    : vehicle_{s.vehicle},
      airframe_{s.vehicle},
      breeze_{s.wind, own_seed(s, gusts)},
      receiver_{s.vehicle.gnss, own_seed(s, receiver)},
      filter_{s.vehicle.gnss.sigma.base()},
      pilot_{planned_acceleration_mps2(s.vehicle), s.vehicle.acceleration_limit.base()} {
  fix_ = receiver_.settled_fix_m(airframe_.position_m());
  filter_.restart(fix_);
}

void Aircraft::take_off() {
  wind_estimate_ = breeze_.at_take_off();
  filter_.restart(receiver_.settled_fix_m(airframe_.position_m()));
}

void Aircraft::land() { airframe_.stand(); }

void Aircraft::fly(double stop_m) {
  const Xy measured = receiver_.velocity_mps(airframe_.velocity_mps());
  const Xy wanted = pilot_.steer(stop_m, filter_.estimate_m(), measured);
  // Thrust holds against the wind as estimated so far, so a steady wind leaves no offset.
  const Xy drag = drag_per_s * (wind_estimate_ - airframe_.velocity_mps());
  airframe_.advance(wanted - drag, breeze_.next());
  const Xy felt = (1.0 / drag_per_s) * (airframe_.drag_mps2() - drag);  // wind beyond the estimate
  wind_estimate_ = wind_estimate_ + wind_filter * felt;

  filter_.predict(measured);
  fix_ = receiver_.fix_m(airframe_.position_m());
  filter_.correct(fix_);
  pilot_.observe(filter_.estimate_m());
  stores.fly(vehicle_, control_period_s);
}

double Aircraft::climb_to(double altitude_m, const planner::HeightRule& rule) {
  const double rise_m = next_altitude_m(altitude_m_, altitude_m, rule) - altitude_m_;
  altitude_m_ += rise_m;
  const double level_s = rule.climb_energy_s_per_m * std::max(0.0, rise_m);
  stores.fly(vehicle_, level_s);
  return level_s;
}

bool Aircraft::is_at_rest(double stop_m) const {
  constexpr double reached_m = 0.01, settled_m = 0.5, settled_mps = 0.5;
  const Pace& pace = pilot_.pace();
  return pace.is_at_rest() &&
         pace.along_m() >= std::min(stop_m, pilot_.path().length_m()) - reached_m &&
         std::abs(along_m() - pace.along_m()) < settled_m &&
         norm(airframe_.velocity_mps()) < settled_mps;
}

}  // namespace furrow::agents
