#include "planner/returns/stops.hpp"

#include "core/corner.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace furrow::planner {
namespace {

constexpr double same_place_m = 1e-6;

// A change of speed instead of a sudden one: nothing is lost where both are one.
double change_loss_s(double full_mps, double slow_mps, double acceleration) {
  const double slower_mps = std::max(0.0, full_mps - slow_mps);
  return slower_mps * slower_mps / (2.0 * acceleration * full_mps);
}

// A leg between two speeds, less the same at full speed.
double leg_loss_s(double length_m, double full_mps, double from_mps, double to_mps,
                  double acceleration) {
  if (length_m <= 0.0) return 0.0;
  return leg_time_s(length_m, full_mps, from_mps, to_mps, acceleration) - length_m / full_mps;
}

struct Bend {
  double speed_mps;  // through it
  double loss_s;     // of the arc, against what it takes of its legs at full speed
  double cut_m;      // that, of each
};

// What an aircraft flies between two strips.
class Joint {
 public:
  Joint(const Vehicle& v)
      : acceleration_{planned_acceleration(v).base()},
        cut_m_{0.5 * v.swath.base()},
        min_radius_m_{v.min_turn_radius.base()} {}

  void add(FieldPoint at, Corner corner, double full_mps) {
    if (!places_.empty() && distance(at, places_.back().at).base() < same_place_m) {
      places_.back().corner = std::max(places_.back().corner, corner);
      return;
    }
    places_.push_back({at, corner, full_mps});
  }

  // The first and the last leg are parts of strips, already and still at full speed far off.
  double loss_s() const {
    double sum_s = 0.0, before_mps = 0.0, cut_m = 0.0;
    for (std::size_t i = 1; i + 1 < places_.size(); ++i) {
      const Bend b = bend(i);
      const double full_mps = places_[i].full_mps;
      const double length_m = distance(places_[i - 1].at, places_[i].at).base() - cut_m - b.cut_m;
      sum_s += b.loss_s +
               (i == 1 ? change_loss_s(full_mps, b.speed_mps, acceleration_)
                       : leg_loss_s(length_m, full_mps, before_mps, b.speed_mps, acceleration_));
      before_mps = b.speed_mps;
      cut_m = b.cut_m;
    }
    return sum_s + change_loss_s(places_.back().full_mps, before_mps, acceleration_);
  }

 private:
  struct Place {
    FieldPoint at;
    Corner corner;
    double full_mps;  // on the leg that ends here
  };

  Bend bend(std::size_t i) const {
    const FieldVector in = places_[i].at - places_[i - 1].at;
    const FieldVector out = places_[i + 1].at - places_[i].at;
    const double angle_rad = turn_rad(in, out);
    const double full_mps = std::min(places_[i].full_mps, places_[i + 1].full_mps);
    if (angle_rad <= straight_rad && places_[i].corner != Corner::stop) return {full_mps, 0.0, 0.0};
    const double shorter_m = std::min(distance(places_[i - 1].at, places_[i].at),
                                      distance(places_[i].at, places_[i + 1].at))
                                 .base();
    const auto [cut_m, radius_m] =
        corner_arc(places_[i].corner, angle_rad, shorter_m, cut_m_, min_radius_m_);
    if (radius_m == 0.0) return {0.0, 0.0, 0.0};
    const double arc_mps = std::min(full_mps, arc_speed_mps(acceleration_, radius_m));
    return {arc_mps, radius_m * angle_rad / arc_mps - 2.0 * cut_m / full_mps, cut_m};
  }

  double acceleration_, cut_m_, min_radius_m_;
  std::vector<Place> places_{};
};

// Between rest and `mps`.
double rest_s(double mps, const Vehicle& v) {
  return change_loss_s(mps, 0.0, planned_acceleration(v).base());
}

}  // namespace

double joint_loss_s(const Strip& before, const Strip& next, const Vehicle& v) {
  const double spray_mps = v.spray_speed.base(), ferry_mps = v.ferry_speed.base();
  const bool meets = distance(before.end, next.begin).base() < same_place_m;
  const auto end_corner = [&](const Strip& s) {
    return !sprays_ends(s) ? Corner::cut : meets ? Corner::held : Corner::stop;
  };
  Joint joint{v};
  joint.add(before.begin, Corner::cut, spray_mps);
  joint.add(before.end, end_corner(before), spray_mps);
  for (const FieldPoint at : next.approach) joint.add(at, Corner::held, ferry_mps);
  joint.add(next.begin, end_corner(next), next.continues ? spray_mps : ferry_mps);
  joint.add(next.end, Corner::cut, spray_mps);
  return joint.loss_s();
}

double ferry_loss_s(const Strip& strip, const Vehicle& v) {
  const double spray_mps = v.spray_speed.base(), ferry_mps = v.ferry_speed.base();
  if (sprays_ends(strip)) return 2.0 * rest_s(ferry_mps, v) + rest_s(spray_mps, v);
  return rest_s(ferry_mps, v) +
         change_loss_s(ferry_mps, std::min(ferry_mps, spray_mps), planned_acceleration(v).base());
}

}  // namespace furrow::planner
