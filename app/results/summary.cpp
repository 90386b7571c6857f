#include "app/results/summary.hpp"

#include "app/results/cell_coverage.hpp"
#include "app/results/digest.hpp"
#include "app/results/expectations.hpp"
#include "app/results/fault_figures.hpp"
#include "app/results/footprint.hpp"
#include "app/results/solver_figures.hpp"
#include "app/results/sorties.hpp"
#include "app/results/sweep_coverage.hpp"
#include "app/results/warnings.hpp"
#include "app/results/ways.hpp"
#include "mission/polygon.hpp"
#include "scheduler/shared_air.hpp"
#include "sim/checkers/clearance.hpp"
#include "sim/checkers/separation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace furrow::app {
namespace {

FieldFigures field_figures(const MissionRecord& record) {
  const planner::Route& route = record.plan.route;
  double strips_m = 0;
  std::uint32_t strips = 0;  // those cut for several sorties count once
  for (const planner::Strip& s : route.strips) {
    strips_m += distance(s.begin, s.end).base();
    if (s.joins && !planner::sprays_ends(s)) strips_m += distance(*s.joins, s.begin).base();
    strips += !s.joins;
  }
  const std::optional<Area> stated = record.scenario.stated_area;
  return {.area_m2 = mission::area(record.scenario.field).base(),
          .stated_area_m2 = stated ? std::optional{stated->base()} : std::nullopt,
          .strips = strips,
          .strip_length_m = strips_m,
          .cells = static_cast<std::uint32_t>(route.centers.size() + route.missed.size())};
}

Spread spread(const FlightRecord::Deviation& d) {
  const double mean_square = d.samples > 0 ? d.sum_squares / d.samples : 0;
  return {.samples = d.samples, .rms_m = std::sqrt(mean_square), .max_m = d.largest};
}

DeviationFigures fleet_deviation(const Flown& flown) {
  const auto total = [&](FlightRecord::Deviation FlownUav::*which) {
    double squares = 0;
    Spread sum{};
    for (const FlownUav& uav : flown.uavs) {
      const FlightRecord::Deviation& d = uav.*which;
      sum.samples += d.samples;
      squares += d.sum_squares;
      sum.max_m = std::max(sum.max_m, d.largest);
    }
    if (sum.samples > 0) sum.rms_m = std::sqrt(squares / static_cast<double>(sum.samples));
    return sum;
  };
  return {.truth = total(&FlownUav::truth), .fix = total(&FlownUav::fix)};
}

double open_valve_s(const std::vector<TrackPoint>& track) {
  Duration open{};
  for (std::size_t i = 1; i < track.size(); ++i) {
    if (track[i - 1].spraying) open += track[i].at - track[i - 1].at;
  }
  return seconds(open).base();
}

// When the valve last closed, as far as the track goes; 0 if it never opened.
double last_open_s(const std::vector<TrackPoint>& track) {
  for (std::size_t i = track.size(); i > 0; --i) {
    if (track[i - 1].spraying) return seconds(track[std::min(i, track.size() - 1)].at).base();
  }
  return 0;
}

UavFigures common_figures(const scheduler::UavPlan& uav, double area_m2) {
  UavFigures f{};
  f.id = number(uav.vehicle.id);
  f.strips = uav.strips.count;
  f.area_m2 = area_m2;
  f.planned_spray_ended_s = uav.spray_ends_s;
  f.planned_non_spray_s = uav.solution.plan.non_spray_s;
  f.lower_bound_s = uav.solution.lower_bound_s;
  f.proven = is_proven(uav.solution);
  return f;
}

UavFigures planned_figures(const planner::Route& route, const scheduler::UavPlan& uav,
                           double area_m2) {
  UavFigures f = common_figures(uav, area_m2);
  f.sorties = planned_sorties(route, uav);
  for (const planner::PlannedSortie& s : uav.solution.plan.sorties) {
    f.spray_s += s.spray_m / uav.vehicle.spray_speed.base();
  }
  for (const SortieFigures& s : f.sorties) f.queue_wait_s += s.wait_s;
  f.non_spray_s = uav.solution.plan.non_spray_s + f.queue_wait_s;
  f.spray_ended_s = uav.spray_ends_s;
  f.landed_s = uav.lands_s;
  return f;
}

UavFigures flown_figures(const FlownUav& flown, const planner::Route& route,
                         const scheduler::UavPlan& uav, std::span<const Station> stations,
                         double area_m2) {
  UavFigures f = common_figures(uav, area_m2);
  f.sorties = flown_sorties(flown, route, uav, stations);
  for (const SortieFigures& s : f.sorties) f.queue_wait_s += s.wait_s;
  f.spray_s = open_valve_s(flown.track);
  f.non_spray_s = non_spray_s(f.sorties);
  if (!f.sorties.empty()) {
    f.spray_ended_s = f.sorties.back().spray_ended_s;
    f.landed_s = f.sorties.back().landed_s;
  }
  // A sortie that never ended has no report.
  f.spray_ended_s = std::max(f.spray_ended_s, last_open_s(flown.track));
  f.deviation = {.truth = spread(flown.truth), .fix = spread(flown.fix)};
  return f;
}

// Weighted by the areas that the aircraft are to spray; of the first where there is none.
double mean_rate_l_ha(const MissionRecord& record, const std::vector<UavFigures>& uavs) {
  double litres_times_1e4 = 0, area_m2 = 0;
  for (std::size_t i = 0; i < uavs.size(); ++i) {
    const Vehicle& vehicle = record.plan.uavs[i].vehicle;
    litres_times_1e4 += uavs[i].area_m2 * (application_rate(vehicle) / litres_per_hectare(1));
    area_m2 += uavs[i].area_m2;
  }
  if (area_m2 > 0) return litres_times_1e4 / area_m2;
  return application_rate(record.plan.uavs.front().vehicle) / litres_per_hectare(1);
}

void add_litres(FleetFigures& f, const FootprintFigures& wetted) {
  const double l_m2 = f.rate_l_ha / 10'000;
  f.sprayed_l = l_m2 * (wetted.wetted_m2 + wetted.overlap_m2);
  f.repeated_l = l_m2 * wetted.overlap_m2;
  f.outside_l = l_m2 * wetted.outside_m2;
}

FleetFigures fleet_figures(const MissionRecord& record, const Flown& flown, const Result& result,
                           const MissionWays& ways) {
  FleetFigures f{};
  const bool is_flown = record.mode != Mode::plan;
  f.makespan_s = is_flown ? flown.last_spray_s : record.plan.makespan_s;
  f.planned_makespan_s = record.plan.makespan_s;
  const Length separation = record.scenario.separation;
  if (separation > Length{} && record.plan.uavs.size() > 1) {
    f.planned_in_shared_air_s = scheduler::shared_air_makespan_s(record.plan, separation);
  }
  f.lower_bound_s = record.plan.lower_bound_s;
  f.bound = record.plan.bound;
  if (result.completed) f.gap = gap_above(f.makespan_s, f.lower_bound_s);
  for (const UavFigures& uav : result.uavs) {
    f.spray_s += uav.spray_s;
    f.non_spray_s += uav.non_spray_s;
    f.queue_wait_s += uav.queue_wait_s;
    f.ferry_m += uav.ferry_m;
  }
  f.route_m = length_m(ways.at_work);
  f.flown_outside_m = outside_m(record, ways.whole);
  f.outside_at_work_m = outside_m(record, ways.at_work);
  if (!result.survey) f.rate_l_ha = mean_rate_l_ha(record, result.uavs);
  add_litres(f, result.footprint);
  return f;
}

std::vector<BatteryFigures> battery_figures(const std::vector<UavFigures>& uavs) {
  std::vector<BatteryFigures> batteries;
  for (const UavFigures& uav : uavs) {
    std::map<std::uint32_t, double> used;
    for (const SortieFigures& s : uav.sorties) used[s.pack] += s.battery_used;
    for (const auto& [pack, share] : used) batteries.push_back({uav.id, pack, share});
  }
  return batteries;
}

std::vector<StationFigures> station_figures(const MissionRecord& record, const Flown& flown,
                                            const std::vector<UavFigures>& uavs) {
  std::vector<StationFigures> stations;
  for (const Station& station : record.scenario.stations) {
    StationFigures f{.id = number(station.id),
                     .swaps = 0,
                     .filled_l = 0,
                     .bays = {},
                     .available_from_s = station.available_from.base(),
                     .available_until_s = {}};
    if (station.available_until) f.available_until_s = station.available_until->base();
    for (std::uint32_t bay = 1; bay <= station.bays; ++bay) f.bays.push_back({bay, 0, 0});
    for (std::size_t i = 0; i < uavs.size(); ++i) {
      const double tank_l = record.plan.uavs[i].vehicle.tank.base();
      for (const SortieFigures& s : uavs[i].sorties) {
        if (s.station != f.id || s.bay < 1 || s.bay > station.bays) continue;
        f.swaps += s.battery_swap_s > 0;
        f.filled_l += s.fill * tank_l;
        ++f.bays[s.bay - 1].services;
        f.bays[s.bay - 1].busy_s += s.ready_s - s.service_began_s;
      }
    }
    if (const auto said = flown.stations.find(station.id); said != flown.stations.end()) {
      f.swaps = said->second.swaps;
      f.filled_l = said->second.filled.base();
    }
    stations.push_back(std::move(f));
  }
  return stations;
}

SeparationFigures separation_figures(const MissionRecord& record, const Flown& flown) {
  std::vector<sim::AirTrack> tracks;
  tracks.reserve(flown.uavs.size());
  for (const FlownUav& uav : flown.uavs) {
    tracks.push_back({uav.track, {}});
    for (const SortieReport& s : uav.sorties) tracks.back().landings.push_back(s.landed);
  }
  const double distance_m = record.scenario.separation.base();
  const sim::Separation found = sim::separation(tracks, distance_m);
  SeparationFigures f{.distance_m = distance_m,
                      .encounters = static_cast<std::uint32_t>(found.encounters.size()),
                      .near_s = 0,
                      .closest_m = found.closest_m,
                      .first_s = {}};
  for (const sim::Encounter& e : found.encounters) f.near_s += seconds(e.to - e.from).base();
  if (f.encounters > 0) f.first_s = seconds(found.encounters.front().from).base();
  return f;
}

std::optional<ClearanceFigures> clearance_figures(const MissionRecord& record) {
  const sim::Facts facts{.field = record.scenario.field,
                         .stations = {},
                         .plan = record.plan,
                         .claim_lease = {},
                         .whole = false,
                         .surprises = record.scenario.surprises};
  const auto least = sim::least_clearance(facts, record.log);
  if (!least) return std::nullopt;
  return ClearanceFigures{.uav = number(least->agent),
                          .obstacle = least->obstacle,
                          .least_m = least->away.base(),
                          .share = least->away / record.plan.safety,
                          .at_s = seconds(least->at).base()};
}

// By aircraft.
std::vector<MissionWays> ways_of(const MissionRecord& record, const Flown& flown) {
  const planner::Route& route = record.plan.route;
  const bool is_survey = planner::is_survey(route);
  std::vector<MissionWays> all;
  all.reserve(record.plan.uavs.size());
  for (std::size_t i = 0; i < record.plan.uavs.size(); ++i) {
    all.push_back(record.mode == Mode::plan ? planned_ways(route, record.plan.uavs[i])
                                            : flown_ways(flown.uavs[i], is_survey));
  }
  return all;
}

std::vector<UavFigures> uav_figures(const MissionRecord& record, const Flown& flown,
                                    const std::vector<MissionWays>& ways) {
  const bool is_flown = record.mode != Mode::plan;
  const planner::Route& route = record.plan.route;
  const std::vector<double> areas_m2 = share_areas_m2(record.plan);
  std::vector<UavFigures> all;
  all.reserve(record.plan.uavs.size());
  for (std::size_t i = 0; i < record.plan.uavs.size(); ++i) {
    const scheduler::UavPlan& uav = record.plan.uavs[i];
    all.push_back(
        is_flown ? flown_figures(flown.uavs[i], route, uav, record.scenario.stations, areas_m2[i])
                 : planned_figures(route, uav, areas_m2[i]));
    all.back().ferry_m = ferry_m(ways[i]);
    all.back().lost = is_flown && flown.lost.contains(uav.vehicle.id);
  }
  return all;
}

OperatorFigures ordered_figures(const Flown& flown) {
  OperatorFigures ordered{.level = std::string{furrow::name(flown.ordered.level)}, .taken_out = {}};
  for (const AgentId agent : flown.ordered.taken_out) ordered.taken_out.push_back(number(agent));
  return ordered;
}

// What was sprayed: by cells, and where rows are swept by footprints; or visited.
void add_coverage(Result& r, const MissionRecord& record, const Flown& flown) {
  const bool is_flown = record.mode != Mode::plan;
  r.sweep = record.plan.sweep;
  if (planner::is_survey(record.plan.route)) {
    r.survey = is_flown ? flown_survey(flown) : planned_survey(record);
  } else if (!r.sweep) {
    r.footprint = footprint(record.scenario.field, record.plan.route,
                            is_flown ? flown.passes : planned_passes(record.plan),
                            record.plan.work_direction_deg);
  }
  r.coverage = is_flown ? flown_coverage(record, flown, r.footprint) : planned_coverage(record);
  if (!r.sweep) return;
  const planner::SprayedAreas areas = sweep_areas(record, is_flown ? &flown : nullptr);
  r.coverage = sweep_coverage(r.coverage, *r.sweep, areas);
  r.footprint = footprint(areas);
}

}  // namespace

Result summary(const MissionRecord& record) { return summary(record, flown(record)); }

Result summary(const MissionRecord& record, const Flown& flown) {
  const bool is_flown = record.mode != Mode::plan;
  const std::vector<MissionWays> ways = ways_of(record, flown);
  Result r{};
  r.scenario = record.scenario.name;
  r.seed = record.scenario.seed;
  r.mode = record.mode;
  r.partial = record.partial;
  r.field = field_figures(record);
  r.datum = record.scenario.datum;
  r.uavs = uav_figures(record, flown, ways);
  r.met = met_figures(record.log);
  add_coverage(r, record, flown);
  r.completed = is_flown   ? !record.partial && flown.last_word && flown.last_word->completed
                : r.survey ? r.survey->visited == r.survey->way_points
                           : r.coverage.abandoned_m2 == 0;
  r.fleet = fleet_figures(record, flown, r, together(ways));
  r.batteries = battery_figures(r.uavs);
  r.solver = solver_figures(record);
  r.deviation = fleet_deviation(flown);
  r.stations = station_figures(record, flown, r.uavs);
  r.warnings = warnings(r, record);
  r.violations = record.violations;
  r.log = {.messages = record.log.size(), .digest = digest(record.log)};
  r.timing = record.timing;
  r.real_time_factor = record.timing.run_wall_s > 0 ? flown.ended_s / record.timing.run_wall_s : 0;
  r.faults = fault_figures(record, flown);
  r.separation = separation_figures(record, flown);
  r.clearance = clearance_figures(record);
  r.ordered = ordered_figures(flown);
  r.expectations = judged(record.scenario.expectations, r);
  return r;
}

}  // namespace furrow::app
