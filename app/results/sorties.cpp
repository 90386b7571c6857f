#include "app/results/sorties.hpp"

#include <algorithm>

namespace furrow::app {
namespace {

double at_s(Instant at) { return seconds(at).base(); }

// When the valve first opened at or after take-off; without a track, when the straight way out
// ends.
double spray_began_s(const FlownUav& flown, const SortieReport& sortie, FieldPoint from,
                     const Vehicle& vehicle) {
  const auto takeoff =
      std::lower_bound(flown.track.begin(), flown.track.end(), sortie.began,
                       [](const TrackPoint& p, Instant began) { return p.at < began; });
  const auto opened =
      std::find_if(takeoff, flown.track.end(), [](const TrackPoint& p) { return p.spraying; });
  if (opened != flown.track.end() && opened->at <= sortie.spray_ended) return at_s(opened->at);
  const Seconds out = distance(from, sortie.resumed_at) / vehicle.ferry_speed;
  return std::min(at_s(sortie.began) + out.base(), at_s(sortie.spray_ended));
}

FieldPoint position_of(StationId id, std::span<const Station> stations) {
  const auto station =
      std::find_if(stations.begin(), stations.end(), [id](const Station& s) { return s.id == id; });
  return station == stations.end() ? FieldPoint{} : station->position;
}

FieldPoint stop_of(const planner::Route& route, std::uint32_t cell) {
  return planner::stop_point(route, route.strips[planner::strip_of(route, cell)], cell);
}

// Where a sortie begins after cell `index` of the share; 0: with it.
FieldPoint planned_start(const planner::Route& route, const scheduler::UavPlan& uav,
                         std::uint32_t index) {
  const std::uint32_t cell = uav.cells.first + index;
  if (index > 0) return planner::resume_point(route, cell);
  return planner::start_point(route, route.strips[planner::strip_of(route, cell)], cell);
}

double round_trip_m(const planner::Route& route, const Vehicle& vehicle, FieldPoint from,
                    FieldPoint station, FieldPoint to) {
  const auto ferry_m = [&](FieldPoint at) {
    return route.ferries.ferry_length(at, station, vehicle).base();
  };
  return ferry_m(from) + ferry_m(to);
}

}  // namespace

std::vector<SortieFigures> planned_sorties(const planner::Route& route,
                                           const scheduler::UavPlan& uav) {
  const auto& sorties = uav.solution.plan.sorties;
  std::vector<SortieFigures> figures;
  double ready_s = 0;
  for (std::size_t k = 0; k < sorties.size(); ++k) {
    const planner::PlannedSortie& s = sorties[k];
    const scheduler::Visit* visit = k < uav.visits.size() ? &uav.visits[k] : nullptr;
    const double landed_s = visit ? visit->arrives_s : uav.lands_s;
    SortieFigures f{};
    f.start = planned_start(route, uav, s.first);
    f.returned = stop_of(route, uav.cells.first + s.last);
    f.spray_m = s.spray_m;
    f.flight_s = s.fly_out_s + s.spray_s + s.fly_back_s;
    f.pack = s.pack;
    f.battery_used = s.battery_used;
    f.began_s = ready_s;
    f.spray_began_s = f.began_s + s.fly_out_s;
    f.spray_ended_s = landed_s - s.fly_back_s;
    f.landed_s = landed_s;
    if (visit) {
      const Station& station = scheduler::landing(uav, k);
      f.round_trip_m = round_trip_m(route, uav.vehicle, f.returned, station.position,
                                    planned_start(route, uav, s.last));
      f.battery_swap_s = s.battery_swap_s;
      f.fill_s = s.fill_s;
      f.fill = k + 1 < sorties.size() ? sorties[k + 1].spray_m / tank_range(uav.vehicle).base() : 0;
      f.wait_s = visit->starts_s - visit->arrives_s;
      f.station = number(station.id);
      f.bay = visit->bay;
      f.service_began_s = visit->starts_s;
      f.ready_s = ready_s = visit->ready_s;
    }
    figures.push_back(f);
  }
  return figures;
}

std::vector<SortieFigures> flown_sorties(const FlownUav& flown, const planner::Route& route,
                                         const scheduler::UavPlan& uav,
                                         std::span<const Station> stations) {
  std::vector<SortieFigures> figures;
  FieldPoint from = uav.vehicle.home;
  for (std::size_t k = 0; k < flown.sorties.size(); ++k) {
    const SortieReport& s = flown.sorties[k];
    SortieFigures f{};
    f.start = s.resumed_at;
    f.returned = s.returned_at;
    f.spray_m = s.sprayed.base();
    f.flight_s = s.flight.base();
    f.pack = s.pack;
    f.battery_used = s.battery_used;
    f.began_s = at_s(s.began);
    f.spray_began_s = spray_began_s(flown, s, from, uav.vehicle);
    f.spray_ended_s = at_s(s.spray_ended);
    f.landed_s = at_s(s.landed);
    if (s.serviced) {
      from = position_of(s.station, stations);
      const bool is_last = k + 1 == flown.sorties.size();
      const FieldPoint next = is_last ? s.returned_at : flown.sorties[k + 1].resumed_at;
      f.round_trip_m = round_trip_m(route, uav.vehicle, s.returned_at, from, next);
      f.battery_swap_s = s.swapped ? s.swap_time.base() : 0;
      f.fill_s = s.fill_time.base();
      f.fill = s.filled;
      f.wait_s = s.wait.base();
      f.station = number(s.station);
      f.bay = s.bay;
      f.service_began_s = f.landed_s + f.wait_s;
      f.ready_s = f.service_began_s + std::max(f.battery_swap_s, f.fill_s);
    }
    figures.push_back(f);
  }
  return figures;
}

double non_spray_s(const std::vector<SortieFigures>& sorties) {
  double sum_s = 0;
  for (std::size_t k = 0; k + 1 < sorties.size(); ++k) {
    const SortieFigures& s = sorties[k];
    const SortieFigures& next = sorties[k + 1];
    sum_s += s.landed_s - s.spray_ended_s;                     // way home
    sum_s += s.wait_s + std::max(s.battery_swap_s, s.fill_s);  // at the station
    sum_s += next.spray_began_s - next.began_s;                // way out
  }
  return sum_s;
}

}  // namespace furrow::app
