#include "planner/terrain/relief.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

std::vector<WayPoint> Relief::way_at(FieldPoint from, std::span<const FieldPoint> between,
                                     std::span<const double> altitudes_m, FieldPoint to) const {
  require(between.size() == altitudes_m.size(), "each place on a way has its height");
  const auto place = [](FieldPoint p, double z_m) { return WayPoint{p.x.base(), p.y.base(), z_m}; };
  std::vector<WayPoint> way{place(from, work_altitude_m(from))};
  for (std::size_t i = 0; i < between.size(); ++i) {
    way.push_back(place(between[i], altitudes_m[i]));
  }
  way.push_back(place(to, work_altitude_m(to)));
  return way;
}

AirWay Relief::straight(std::span<const WayPoint> way, Speed speed) const {
  require(way.size() >= 2, "a way has two ends");
  AirWay made{way.front().z_m, {}};
  for (std::size_t k = 1; k < way.size(); ++k) {
    const double run_m = std::hypot(way[k].x_m - way[k - 1].x_m, way[k].y_m - way[k - 1].y_m);
    const double limit = limit_mps(run_m, way[k].z_m - way[k - 1].z_m, speed.base());
    made.legs.push_back({at_m(way[k].x_m, way[k].y_m), limit, way[k].z_m, true});
  }
  return made;
}

AirWay Relief::ferry(std::span<const FieldPoint> way, Speed speed, Length layer,
                     std::optional<Length> begins) const {
  require(way.size() >= 2, "a ferry has two ends");
  const Course c = course(way);
  const double up = rule_.climb / speed, down = rule_.descent / speed;
  const std::vector<double> lowest_m = lowest_heights_m(c, up, down);
  const double spray_m = rule_.spray_height.base();
  const double work_m = c.ground_m.front() + spray_m, arrives_m = c.ground_m.back() + spray_m;
  const double leaves_m = begins ? std::max(work_m, begins->base()) : work_m;
  double gone_m = 0, left_m = std::accumulate(c.run_m.begin(), c.run_m.end(), 0.0);
  AirWay made{leaves_m, {}};
  made.legs.reserve(c.run_m.size());
  double before_m = leaves_m;
  for (std::size_t k = 1; k < lowest_m.size(); ++k) {
    const double run_m = c.run_m[k - 1];
    gone_m += run_m;
    left_m -= run_m;
    const double wanted_m = std::min({lowest_m[k] + layer.base(), leaves_m + up * gone_m,
                                      arrives_m + down * std::max(0.0, left_m)});
    const double here_m = std::max(wanted_m, c.ground_m[2 * k] + spray_m);
    made.legs.push_back({at_m(c.x_m[2 * k], c.y_m[2 * k]),
                         limit_mps(run_m, here_m - before_m, speed.base()), here_m, false});
    before_m = here_m;
  }
  for (const std::size_t k : c.bends) made.legs[k - 1].bends = true;
  return made;
}

Relief::Course Relief::course(std::span<const FieldPoint> way) const {
  Course c{{way.front().x.base()}, {way.front().y.base()}, {}, {}, {}};
  for (std::size_t k = 1; k < way.size(); ++k) {
    const FieldVector leg = way[k] - way[k - 1];
    const double length_m = distance(way[k - 1], way[k]).base();
    if (length_m == 0) continue;
    const int n = pieces(length_m, pitch_m_);
    for (int i = 1; i <= 2 * n; ++i) {
      const double share = 0.5 * i / n;
      c.x_m.push_back((way[k - 1].x + share * leg.x).base());
      c.y_m.push_back((way[k - 1].y + share * leg.y).base());
    }
    c.x_m.back() = way[k].x.base();  // not by rounding beside it
    c.y_m.back() = way[k].y.base();
    c.run_m.insert(c.run_m.end(), static_cast<std::size_t>(n), length_m / n);
    c.bends.push_back(c.run_m.size());
  }
  c.ground_m.resize(c.x_m.size());
  surface_.heights_m(c.x_m.data(), c.y_m.data(), c.x_m.size(), c.ground_m.data());
  return c;
}

// Each place has the clearance over the ground up to halfway to its neighbours.
std::vector<double> Relief::lowest_heights_m(const Course& c, double up, double down) const {
  const double kept_m = (rule_.clearance + surface_.error()).base();
  std::vector<double> made(c.run_m.size() + 1);
  for (std::size_t k = 0; k < made.size(); ++k) {
    double ground_m = c.ground_m[2 * k];
    if (k > 0) ground_m = std::max(ground_m, c.ground_m[2 * k - 1]);
    if (k + 1 < made.size()) ground_m = std::max(ground_m, c.ground_m[2 * k + 1]);
    made[k] = ground_m + kept_m;
  }
  for (std::size_t k = made.size() - 1; k > 0; --k) {
    made[k - 1] = std::max(made[k - 1], made[k] - up * c.run_m[k - 1]);
  }
  for (std::size_t k = 1; k < made.size(); ++k) {
    made[k] = std::max(made[k], made[k - 1] - down * c.run_m[k - 1]);
  }
  return made;
}

double Relief::highest_ferry_m() const {
  const std::vector<float>& heights = surface_.raster().heights_m;
  const double highest_m = *std::max_element(heights.begin(), heights.end());
  const Length layers = (rule_.layers - 1.0) * rule_.layer;
  const Length kept = std::max(rule_.clearance + surface_.error() + layers, rule_.spray_height);
  return highest_m + kept.base();
}

std::vector<std::size_t> Relief::in_the_way() const {
  const std::vector<float>& heights = surface_.raster().heights_m;
  const double lowest_m =
      *std::min_element(heights.begin(), heights.end()) + rule_.spray_height.base();
  const double highest_m =
      std::min(highest_ferry_m(), rule_.ceiling.value_or(metres(INFINITY)).base());
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < keep_out_.size(); ++i) {
    if (keep_out_[i].bottom_m <= highest_m && keep_out_[i].top_m >= lowest_m) indices.push_back(i);
  }
  return indices;
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
