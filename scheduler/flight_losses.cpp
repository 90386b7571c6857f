#include "scheduler/flight_losses.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>

namespace furrow::scheduler {
namespace {

/// A line through what flights of one kind of aircraft lose, by the ways between strips of each.
struct LossLine {
  double n = 0.0, hops = 0.0, squares = 0.0, lost_s = 0.0, products = 0.0;

  void add(double between, double s) {
    n += 1.0;
    hops += between;
    squares += between * between;
    lost_s += s;
    products += between * s;
  }
  FlightLoss loss() const {
    const double spread = n * squares - hops * hops;
    const double hop_s =
        spread > 0.5 ? std::max(0.0, (n * products - hops * lost_s) / spread) : 0.0;
    return {.flight_s = std::max(0.0, (lost_s - hop_s * hops) / n), .hop_s = hop_s};
  }
};

}  // namespace

std::vector<FlightLoss> flight_losses(const FlownLists& flown) {
  const auto quickness = [](const Vehicle& v) {
    return std::tuple{v.spray_speed, v.ferry_speed, v.acceleration_limit};
  };
  std::map<std::tuple<Speed, Speed, Acceleration>, LossLine> lines;
  for (std::size_t u = 0; u < flown.uavs.size(); ++u) {
    const UavPlan& uav = flown.uavs[u];
    const Itinerary& it = flown.itineraries[u];
    const auto strip_at = [&](std::uint32_t i) {
      return static_cast<double>(planner::strip_of(flown.order.route, uav.cells.first + i));
    };
    for (std::size_t k = 0; k < uav.solution.plan.sorties.size(); ++k) {
      const planner::PlannedSortie& s = uav.solution.plan.sorties[k];
      const double flight_s =
          k < it.flights_s.size() ? it.flights_s[k] : it.last_spray_s + it.last_home_s;
      lines[quickness(uav.vehicle)].add(strip_at(s.last) - strip_at(k == 0 ? 0 : s.first + 1),
                                        flight_s - s.fly_out_s - s.spray_s - s.fly_back_s);
    }
  }
  std::vector<FlightLoss> all;
  for (const UavPlan& uav : flown.uavs) {
    const auto line = lines.find(quickness(uav.vehicle));
    all.push_back(line == lines.end() ? FlightLoss{} : line->second.loss());
  }
  return all;
}

}  // namespace furrow::scheduler
