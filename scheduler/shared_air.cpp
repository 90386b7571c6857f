#include "scheduler/shared_air.hpp"

#include "scheduler/airspace.hpp"
#include "scheduler/forecast.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::scheduler {
namespace {

/// Where flights begin or end, each place once.
class Places {
 public:
  std::uint32_t index(FieldPoint at) {
    const auto known = std::find(places_.begin(), places_.end(), at);
    const auto i = static_cast<std::uint32_t>(known - places_.begin());
    if (known == places_.end()) places_.push_back(at);
    return i;
  }

 private:
  std::vector<FieldPoint> places_{};
};

std::vector<Station> stations_of(const FleetPlan& plan) {
  std::vector<Station> stations;
  for (const UavPlan& uav : plan.uavs) {
    place_of(uav.station, stations);
    for (const Station& s : uav.landings) place_of(s, stations);
  }
  return stations;
}

/// The times of a plan without its waits.
Itinerary itinerary(const UavPlan& uav, std::vector<Station>& stations) {
  Itinerary it = grounded(uav.vehicle.id);
  it.flies = uav.spray_ends_s > 0.0;
  it.begins_s = uav.vehicle.available_from.base();
  double leaves_s = it.begins_s;
  for (std::size_t n = 0; n < uav.visits.size(); ++n) {
    const Visit& visit = uav.visits[n];
    it.flights_s.push_back(visit.arrives_s - leaves_s);
    it.services_s.push_back(visit.ready_s - visit.starts_s);
    it.stations.push_back(static_cast<std::uint32_t>(place_of(landing(uav, n), stations)));
    leaves_s = visit.ready_s;
  }
  it.last_spray_s = uav.spray_ends_s - leaves_s;
  it.last_home_s = uav.lands_s - uav.spray_ends_s;
  return it;
}

}  // namespace

double take_off_slot_s(const Vehicle& vehicle, Length separation) {
  const double apart_m = separation.base() + Airspace::level_room_m;
  const double step_s = seconds(Airspace::step).base();
  const double takes_s = std::sqrt(2.0 * apart_m / planned_acceleration(vehicle).base());
  return std::ceil(takes_s / step_s) * step_s;
}

double shared_air_makespan_s(const FleetPlan& plan, Length separation) {
  std::vector<Station> stations = stations_of(plan);
  Places places;
  Pads pads;
  for (const Station& s : stations) pads.stations.push_back(places.index(s.position));
  std::vector<Itinerary> itineraries;
  for (const UavPlan& uav : plan.uavs) {
    itineraries.push_back(itinerary(uav, stations));
    pads.homes.push_back(places.index(uav.vehicle.home));
    pads.slot_s = std::max(pads.slot_s, take_off_slot_s(uav.vehicle, separation));
  }
  return forecast(itineraries, stations, pads).makespan_s;
}

}  // namespace furrow::scheduler
