#include "planner/terrain/relief.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner {
namespace {

constexpr double least_pitch_m = 2, most_pitch_m = 20;

double pitch_of(const Surface& surface) {
  return std::clamp(surface.raster().step.base(), least_pitch_m, most_pitch_m);
}

int pieces(double length_m, double pitch_m) {
  return std::max(1, static_cast<int>(std::ceil(length_m / pitch_m - 1e-9)));
}

}  // namespace

Relief::Relief(Surface surface, HeightRule rule, std::vector<KeepOut> keep_out)
    : surface_{std::move(surface)},
      rule_{rule},
      keep_out_{std::move(keep_out)},
      pitch_m_{pitch_of(surface_)} {
  require(rule_.climb > Speed{} && rule_.descent > Speed{} && rule_.slowest > 0,
          "an aircraft that follows the ground climbs and descends");
}

Relief::Relief(const TerrainModel& model, const Extent& extent)
    : Relief{planner::surface(model.ground, extent), model.rule, model.keep_out} {}

double Relief::work_altitude_m(FieldPoint p) const {
  return (surface_.height(p) + rule_.spray_height).base();
}

// The speed over the ground at which a rise takes as long as climbing or descending it.
double Relief::limit_mps(double run_m, double rise_m, double speed_mps) const {
  if (rise_m == 0 || run_m <= 0) return speed_mps;
  const double vertical_mps = (rise_m > 0 ? rule_.climb : rule_.descent).base();
  return std::clamp(vertical_mps * run_m / std::abs(rise_m), rule_.slowest * speed_mps, speed_mps);
}

AirWay Relief::contour(FieldPoint from, FieldPoint to, Speed speed) const {
  AirWay way{work_altitude_m(from), {}};
  const double length_m = distance(from, to).base();
  const int n = pieces(length_m, pitch_m_);
  double before_m = way.altitude_m;
  for (int i = 1; i <= n; ++i) {
    const double t = static_cast<double>(i) / n;
    const FieldPoint p = i == n ? to : from + FieldVector{t * (to.x - from.x), t * (to.y - from.y)};
    const double here_m = work_altitude_m(p);
    way.legs.push_back({p, limit_mps(length_m / n, here_m - before_m, speed.base()), here_m});
    before_m = here_m;
  }
  return way;
}

AirWay Relief::ferry(std::span<const WayPoint> way, Speed speed, Length layer) const {
  require(way.size() >= 2, "a ferry has two ends");
  double left_m = 0;
  for (std::size_t k = 1; k < way.size(); ++k) {
    left_m += std::hypot(way[k].x_m - way[k - 1].x_m, way[k].y_m - way[k - 1].y_m);
  }
  const auto place = [](WayPoint p) { return at_m(p.x_m, p.y_m); };
  const double leaves_m = work_altitude_m(place(way.front()));
  const double arrives_m = work_altitude_m(place(way.back()));
  const double up = rule_.climb / speed, down = rule_.descent / speed;
  AirWay made{leaves_m, {}};
  double gone_m = 0, before_m = leaves_m;
  for (std::size_t k = 1; k < way.size(); ++k) {
    const double length_m = std::hypot(way[k].x_m - way[k - 1].x_m, way[k].y_m - way[k - 1].y_m);
    const int n = pieces(length_m, pitch_m_);
    for (int i = 1; length_m > 0 && i <= n; ++i) {
      const WayPoint p = between(way[k - 1], way[k], static_cast<double>(i) / n);
      gone_m += length_m / n;
      left_m -= length_m / n;
      const double wanted_m = std::min(
          {p.z_m + layer.base(), leaves_m + up * gone_m, arrives_m + down * std::max(0.0, left_m)});
      const double here_m = std::max(wanted_m, work_altitude_m(place(p)));
      const double limit = limit_mps(length_m / n, here_m - before_m, speed.base());
      made.legs.push_back({place(p), limit, here_m});
      before_m = here_m;
    }
  }
  return made;
}

Length Relief::layer_of(AgentId agent) const {
  return static_cast<double>((number(agent) - 1) % rule_.layers) * rule_.layer;
}

FlightCost Relief::cost(FieldPoint from, const AirWay& way) const {
  FlightCost sum{};
  double altitude_m = way.altitude_m, climb_m = 0;
  for (const AirLeg& leg : way.legs) {
    sum.time_s += distance(from, leg.to).base() / leg.limit_mps;
    climb_m += std::max(0.0, leg.altitude_m - altitude_m);
    altitude_m = leg.altitude_m;
    from = leg.to;
  }
  sum.energy_s = sum.time_s + rule_.climb_energy_s_per_m * climb_m;
  return sum;
}

double Relief::too_steep_m(FieldPoint from, const AirWay& way) const {
  constexpr double rounding = 1 + 1e-9;
  double altitude_m = way.altitude_m, sum_m = 0;
  for (const AirLeg& leg : way.legs) {
    const double run_m = distance(from, leg.to).base(), rise_m = leg.altitude_m - altitude_m;
    const double vertical_mps = (rise_m > 0 ? rule_.climb : rule_.descent).base();
    if (run_m > 0 && std::abs(rise_m) / run_m * leg.limit_mps > vertical_mps * rounding) {
      sum_m += run_m;
    }
    altitude_m = leg.altitude_m;
    from = leg.to;
  }
  return sum_m;
}

}  // namespace furrow::planner
