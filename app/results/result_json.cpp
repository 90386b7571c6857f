#include "app/results/result_json.hpp"

#include "app/exports/missions_json.hpp"
#include "app/results/rounding.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace furrow::app {
namespace {

using Json = nlohmann::ordered_json;

Json rounded(const std::optional<double>& value) {
  return value ? Json(app::rounded(*value)) : Json{};
}

Json point(FieldPoint p) { return Json::array({rounded(p.x.base()), rounded(p.y.base())}); }

template <class T>
Json list(const std::vector<T>& values, Json (*json)(const T&)) {
  Json all = Json::array();
  for (const T& value : values) all.push_back(json(value));
  return all;
}

Json json(const FieldFigures& f) {
  return {{"area_m2", rounded(f.area_m2)},
          {"stated_area_m2", rounded(f.stated_area_m2)},
          {"strips", f.strips},
          {"strip_length_m", rounded(f.strip_length_m)},
          {"cells", f.cells}};
}

Json json(const planner::AvoidanceFigures& f) {
  return {{"missed_m2", rounded(f.missed.base())},
          {"repeated_m2", rounded(f.repeated.base())},
          {"extra_m", rounded(f.extra.base())}};
}

Json json(const MetFigures& m) {
  return {{"obstacles", m.obstacles},
          {"detours", m.detours},
          {"closed", m.closed},
          {"blocked", m.blocked}};
}

Json json(const planner::AvoidanceRecord& r, const MetFigures& met) {
  Json made = json(r.planned);
  made.update({{"safety_m", rounded(r.safety.base())},
               {"targets", r.planned.targets},
               {"crowds", r.planned.crowds},
               {"detours", r.planned.detours},
               {"closed", r.planned.closed},
               {"blocked", r.planned.blocked},
               {"exact", r.planned.exact},
               {"iterations", r.planned.iterations},
               {"dubins_turns", r.turns},
               {"turned_on_the_spot", r.unturned},
               {"unjoined", r.unjoined},
               {"outlines_that_end_rows", r.ended},
               {"met", json(met)},
               {"classic", json(r.classic)}});
  return made;
}

Json json(const planner::SweepFigures& s, const MetFigures& met) {
  return {{"parts", s.parts},
          {"sprayed_m", rounded(s.sprayed.base())},
          {"route_m", rounded(s.route.base())},
          {"order_bound_m", rounded(s.order_bound.base())},
          {"order_exact", s.order_exact},
          {"dropped_m2", rounded(s.dropped.base())},
          {"avoidance", s.avoidance ? json(*s.avoidance, met) : Json{}}};
}

Json json(const SurveyFigures& s) {
  return {{"way_points", s.way_points}, {"visited", s.visited}, {"uncertain", s.uncertain}};
}

Json json(const CoverageFigures& c) {
  return {{"covered_m2", rounded(c.covered_m2)},    {"missed_m2", rounded(c.missed_m2)},
          {"repeated_m2", rounded(c.repeated_m2)},  {"outside_m2", rounded(c.outside_m2)},
          {"unrouted_m2", rounded(c.unrouted_m2)},  {"abandoned_m2", rounded(c.abandoned_m2)},
          {"uncertain_m2", rounded(c.uncertain_m2)}};
}

Json json(const FootprintFigures& f) {
  return {{"wetted_m2", rounded(f.wetted_m2)},
          {"footprint_missed_m2", rounded(f.missed_m2)},
          {"footprint_overlap_m2", rounded(f.overlap_m2)},
          {"footprint_outside_m2", rounded(f.outside_m2)}};
}

Json json(const FleetFigures& f) {
  return {{"makespan_s", rounded(f.makespan_s)},
          {"planned_makespan_s", rounded(f.planned_makespan_s)},
          {"planned_in_shared_air_s", rounded(f.planned_in_shared_air_s)},
          {"lower_bound_s", rounded(f.lower_bound_s)},
          {"bound", f.bound},
          {"gap", rounded(f.gap)},
          {"spray_s", rounded(f.spray_s)},
          {"non_spray_s", rounded(f.non_spray_s)},
          {"queue_wait_s", rounded(f.queue_wait_s)},
          {"route_m", rounded(f.route_m)},
          {"ferry_m", rounded(f.ferry_m)},
          {"flown_outside_m", rounded(f.flown_outside_m)},
          {"outside_at_work_m", rounded(f.outside_at_work_m)},
          {"rate_l_ha", rounded(f.rate_l_ha)},
          {"sprayed_l", rounded(f.sprayed_l)},
          {"repeated_l", rounded(f.repeated_l)},
          {"outside_l", rounded(f.outside_l)}};
}

Json json(const SortieFigures& s) {
  const bool is_serviced = s.bay > 0;
  return {{"start_m", point(s.start)},
          {"return_m", point(s.returned)},
          {"spray_m", rounded(s.spray_m)},
          {"round_trip_m", rounded(s.round_trip_m)},
          {"flight_s", rounded(s.flight_s)},
          {"battery_used", rounded(s.battery_used)},
          {"battery_swap_s", rounded(s.battery_swap_s)},
          {"fill_s", rounded(s.fill_s)},
          {"wait_s", rounded(s.wait_s)},
          {"bay", is_serviced ? Json(s.bay) : Json{}},
          {"station", is_serviced ? Json(s.station) : Json{}},
          {"fill", rounded(s.fill)},
          {"pack", s.pack},
          {"began_s", rounded(s.began_s)},
          {"spray_began_s", rounded(s.spray_began_s)},
          {"spray_ended_s", rounded(s.spray_ended_s)},
          {"landed_s", rounded(s.landed_s)}};
}

Json json(const Spread& s) {
  return {{"samples", s.samples}, {"rms_m", rounded(s.rms_m)}, {"max_m", rounded(s.max_m)}};
}

Json json(const DeviationFigures& d) { return {{"truth", json(d.truth)}, {"fix", json(d.fix)}}; }

Json json(const UavFigures& u) {
  return {{"id", u.id},
          {"strips", u.strips},
          {"area_m2", rounded(u.area_m2)},
          {"non_spray_s", rounded(u.non_spray_s)},
          {"spray_s", rounded(u.spray_s)},
          {"queue_wait_s", rounded(u.queue_wait_s)},
          {"ferry_m", rounded(u.ferry_m)},
          {"spray_ended_s", rounded(u.spray_ended_s)},
          {"landed_s", rounded(u.landed_s)},
          {"planned_spray_ended_s", rounded(u.planned_spray_ended_s)},
          {"planned_non_spray_s", rounded(u.planned_non_spray_s)},
          {"lower_bound_s", rounded(u.lower_bound_s)},
          {"proven", u.proven},
          {"lost", u.lost},
          {"deviation", json(u.deviation)},
          {"sorties", list<SortieFigures>(u.sorties, json)}};
}

Json json(const BatteryFigures& b) {
  return {{"uav", b.uav}, {"pack", b.pack}, {"used", rounded(b.used)}};
}

Json json(const scheduler::Yardsticks& y) {
  return {{"joint", y.is_joint},
          {"shares_s", rounded(y.shares_s)},
          {"till_empty_s", rounded(y.till_empty_s)},
          {"simple_s", rounded(y.simple_s)}};
}

Json json(const SolverFigures& s) {
  return {{"returns", s.returns},
          {"refined", s.refined},
          {"return_points", s.return_points},
          {"round_trips_m", rounded(s.round_trips_m)},
          {"swaps", s.swaps},
          {"swap_s", rounded(s.swap_s)},
          {"fill_s", rounded(s.fill_s)},
          {"service_s", rounded(s.service_s)},
          {"non_spray_s", rounded(s.non_spray_s)},
          {"gsa_s", rounded(s.gsa_s)},
          {"optimum_s", rounded(s.optimum_s)},
          {"lower_bound_s", rounded(s.lower_bound_s)},
          {"proven", s.proven},
          {"gap", rounded(s.gap)},
          {"until_empty_s", rounded(s.until_empty_s)},
          {"anywhere_lower_bound_s", rounded(s.anywhere_lower_bound_s)},
          {"anywhere_gap", rounded(s.anywhere_gap)},
          {"evaluations", s.evaluations},
          {"wall_s", rounded(s.wall_s)},
          {"fleet", s.yardsticks ? json(*s.yardsticks) : Json{}}};
}

Json json(const BayFigures& b) {
  return {{"bay", b.bay}, {"services", b.services}, {"busy_s", rounded(b.busy_s)}};
}

Json json(const StationFigures& s) {
  return {{"id", s.id},
          {"swaps", s.swaps},
          {"filled_l", rounded(s.filled_l)},
          {"available_from_s", rounded(s.available_from_s)},
          {"available_until_s", s.available_until_s ? Json(rounded(*s.available_until_s)) : Json{}},
          {"bays", list<BayFigures>(s.bays, json)}};
}

Json json(const Violation& v) {
  return {{"law", v.law}, {"at_s", rounded(seconds(v.at).base())}, {"detail", v.detail}};
}

Json json(const FaultFigures& f) {
  return {{"at_s", rounded(f.at_s)},
          {"kind", f.kind},
          {"target", f.target},
          {"noticed_s", rounded(f.noticed_s)}};
}

Json json(const SeparationFigures& s) {
  return {{"distance_m", rounded(s.distance_m)},
          {"encounters", s.encounters},
          {"near_s", rounded(s.near_s)},
          {"closest_m", rounded(s.closest_m)},
          {"first_s", rounded(s.first_s)}};
}

Json json(const ClearanceFigures& c) {
  return {{"uav", c.uav},
          {"obstacle", c.obstacle},
          {"least_m", rounded(c.least_m)},
          {"share", rounded(c.share)},
          {"at_s", rounded(c.at_s)}};
}

Json json(const ExpectationFigures& e) {
  Json all{{"key", e.key}, {"met", e.met}, {"value", rounded(e.value)}};
  if (e.min) all["min"] = rounded(e.min);
  if (e.max) all["max"] = rounded(e.max);
  if (!e.message.empty()) all["message"] = e.message;
  return all;
}

Json laws(const std::vector<Violation>& violations) {
  return {{"violations", violations.size()}, {"broken", list<Violation>(violations, json)}};
}

Json timing(const Result& r) {
  return {{"plan_wall_s", rounded(r.timing.plan_wall_s)},
          {"run_wall_s", rounded(r.timing.run_wall_s)},
          {"real_time_factor", rounded(r.real_time_factor)}};
}

}  // namespace

std::string result_json(const Result& r) {
  Json all{{"version", 1},
           {"scenario", r.scenario},
           {"seed", r.seed},
           {"mode", name(r.mode)},
           {"partial", r.partial},
           {"completed", r.completed},
           {"field", json(r.field)},
           {"datum", datum_json(r.datum)},
           {"sweep", r.sweep ? json(*r.sweep, r.met) : Json{}},
           {"coverage", json(r.coverage)},
           {"footprint", json(r.footprint)},
           {"fleet", json(r.fleet)},
           {"uavs", list<UavFigures>(r.uavs, json)},
           {"batteries", list<BatteryFigures>(r.batteries, json)},
           {"solver", json(r.solver)},
           {"deviation", json(r.deviation)},
           {"stations", list<StationFigures>(r.stations, json)},
           {"warnings", r.warnings},
           {"laws", laws(r.violations)},
           {"log", {{"messages", r.log.messages}, {"digest", r.log.digest}}},
           {"timing", timing(r)},
           {"faults", list<FaultFigures>(r.faults, json)},
           {"separation", json(r.separation)},
           {"clearance", r.clearance ? json(*r.clearance) : Json{}},
           {"operator", {{"level", r.ordered.level}, {"taken_out", r.ordered.taken_out}}},
           {"expectations", list<ExpectationFigures>(r.expectations, json)}};
  if (r.survey) all["survey"] = json(*r.survey);
  // A name that is not UTF-8 must not stop the results of a mission from being written.
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace furrow::app
