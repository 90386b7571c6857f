#include "scheduler/share_times.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace furrow::scheduler {
namespace {

// As the planner's limits: a sum that meets the tank exactly must not fail it by rounding.
constexpr double widened = 1.0 + 1e-9;
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

double fill_s_per_m(const Vehicle& vehicle, const Station& station) {
  return (station.fill_full - station.fill_base).base() / tank_range(vehicle).base();
}

}  // namespace

RouteLengths route_lengths(const planner::Route& route, std::span<const Station> stations) {
  RouteLengths lengths;
  double ferry_m = 0.0;
  const auto cells = static_cast<std::uint32_t>(route.centers.size());
  const std::vector<planner::CellStop> stops = planner::cell_stops(route, {0, cells});
  for (const planner::CellStop& at : stops) {
    ferry_m += at.approach_m;
    lengths.spray_m.push_back(at.spray_m);
    lengths.ferry_m.push_back(ferry_m);
  }
  for (const planner::Strip& strip : route.strips) {
    const std::uint32_t first = strip.cells.first;
    const bool from_end = planner::sprays_ends(strip);
    lengths.begin_m.push_back(!from_end    ? lengths.spray_m[first]
                              : first == 0 ? 0.0
                                           : lengths.spray_m[first - 1]);
  }
  lengths.nearest_m.assign(route.centers.size(), std::numeric_limits<double>::infinity());
  for (const Station& station : stations) {
    std::vector<double>& home_m = lengths.home_m.emplace_back();
    lengths.stations.push_back(planner::station_lengths(route, station.position));
    const planner::StationLengths& ways = lengths.stations.back();
    for (std::size_t c = 0; c < stops.size(); ++c) {
      home_m.push_back(0.5 * (ways.back_m[c] + ways.out_m[c] - stops[c].skipped_m));
      lengths.nearest_m[c] = std::min(lengths.nearest_m[c], home_m[c]);
    }
  }
  return lengths;
}

std::vector<std::uint32_t> near_stations(const RouteLengths& lengths, std::uint32_t cell) {
  constexpr std::size_t most = 4;
  std::vector<std::uint32_t> near(lengths.home_m.size());
  std::iota(near.begin(), near.end(), 0u);
  if (near.size() <= most) return near;
  std::stable_sort(near.begin(), near.end(), [&](std::uint32_t a, std::uint32_t b) {
    return lengths.home_m[a][cell] < lengths.home_m[b][cell];
  });
  near.resize(most);
  std::sort(near.begin(), near.end());
  return near;
}

std::shared_ptr<const std::vector<double>> FirstFlights::from(FieldPoint home) {
  const auto [known, is_new] = known_m_.try_emplace({home.x.base(), home.y.base()});
  if (is_new) {
    std::vector<double> ways_m;
    ways_m.reserve(route_.strips.size());
    for (const planner::Strip& strip : route_.strips) {
      ways_m.push_back(route_.ferries.length(home, strip.begin).base());
    }
    known->second = std::make_shared<const std::vector<double>>(std::move(ways_m));
  }
  return known->second;
}

Pace pace(FirstFlights& flights, const Vehicle& vehicle, const Station& station,
          std::span<const double> home_m) {
  return {.spray_mps = vehicle.spray_speed.base(),
          .ferry_mps = vehicle.ferry_speed.base(),
          .tank_m = widened * tank_range(vehicle).base(),
          .fill_base_s = station.fill_base.base(),
          .fill_s_per_m = fill_s_per_m(vehicle, station),
          .home_m = home_m,
          .out_m = flights.from(vehicle.home)};
}

Pace fastest_pace(const planner::Route& route, std::span<const Vehicle> vehicles,
                  std::span<const Station> stations, std::span<const double> nearest_m) {
  require(!vehicles.empty() && !stations.empty(), "a fleet has aircraft and stations");
  FirstFlights flights{route};
  Pace best = pace(flights, vehicles[0], stations[0], nearest_m);
  std::vector<double> out_m(route.strips.size(), std::numeric_limits<double>::infinity());
  for (const Vehicle& v : vehicles) {
    best.spray_mps = std::max(best.spray_mps, v.spray_speed.base());
    best.ferry_mps = std::max({best.ferry_mps, v.ferry_speed.base(), best.spray_mps});
    best.tank_m = std::max(best.tank_m, widened * tank_range(v).base());
    for (const Station& s : stations) {
      best.fill_base_s = std::min(best.fill_base_s, s.fill_base.base());
      best.fill_s_per_m = std::min(best.fill_s_per_m, fill_s_per_m(v, s));
    }
  }
  const auto closer = [&](FieldPoint from) {
    const auto from_m = flights.from(from);
    for (std::size_t i = 0; i < out_m.size(); ++i) out_m[i] = std::min(out_m[i], (*from_m)[i]);
  };
  for (const Vehicle& v : vehicles) closer(v.home);
  for (const Station& s : stations) closer(s.position);
  best.out_m = std::make_shared<const std::vector<double>>(std::move(out_m));
  return best;
}

GrowingShare::GrowingShare(const planner::Route& route, const RouteLengths& lengths,
                           const Pace& pace, std::uint32_t first)
    : route_{route},
      lengths_{lengths},
      pace_{pace},
      first_cell_{0},
      next_strip_{first},
      first_m_{0},
      base_s_{0} {
  if (!can_grow()) return;
  first_cell_ = route.strips[first].cells.first;
  first_m_ = lengths.begin_m[first];
  base_s_ = (*pace.out_m)[first] / pace.ferry_mps - first_m_ / pace.spray_mps -
            lengths.ferry_m[first_cell_] / pace.ferry_mps;
}

bool GrowingShare::can_grow() const { return next_strip_ < route_.strips.size(); }

double GrowingShare::grow() {
  require(can_grow(), "a share grows within its route");
  const CellRange cells = route_.strips[next_strip_++].cells;
  double sprayed_s = 0.0;
  for (std::uint32_t c = cells.first; c < end(cells); ++c) {
    const double at_m = lengths_.spray_m[c];
    const double route_s = at_m / pace_.spray_mps + lengths_.ferry_m[c] / pace_.ferry_mps;
    while (head_ < window_.size() && at_m - lengths_.spray_m[window_[head_].cell] > pace_.tank_m) {
      ++head_;
    }
    const double first_sortie_s = at_m - first_m_ <= pace_.tank_m
                                      ? base_s_ + route_s
                                      : std::numeric_limits<double>::infinity();
    const double refilled_s = head_ < window_.size()
                                  ? window_[head_].key_s + route_s + pace_.fill_s_per_m * at_m
                                  : std::numeric_limits<double>::infinity();
    sprayed_s = std::min(first_sortie_s, refilled_s);
    parents_.push_back(refilled_s < first_sortie_s ? window_[head_].cell : none);
    // No return is planned after the first cell alone; see planner::ReturnProblem.
    if (c == first_cell_ && at_m > first_m_) continue;
    // What a later cell pays when the return before it is made here, its own terms left out.
    const double key_s = sprayed_s - route_s + 2.0 * pace_.home_m[c] / pace_.ferry_mps +
                         pace_.fill_base_s - pace_.fill_s_per_m * at_m;
    while (window_.size() > head_ && window_.back().key_s >= key_s) window_.pop_back();
    window_.push_back({c, key_s});
  }
  return sprayed_s;
}

planner::Returns GrowingShare::returns() const {
  planner::Returns returns;
  if (parents_.empty()) return returns;
  for (std::uint32_t c = parents_.back(); c != none; c = parents_[c - first_cell_]) {
    returns.push_back(c - first_cell_);
  }
  std::reverse(returns.begin(), returns.end());
  return returns;
}

}  // namespace furrow::scheduler
