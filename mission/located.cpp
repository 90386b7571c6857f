#include "mission/located.hpp"

#include "mission/place.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace furrow::mission {
namespace {

using planner::PlanError;
using planner::PlanFault;

std::string rule_of(PlanFault fault) {
  switch (fault) {
    case PlanFault::field_invalid: return "must be land that can be planned";
    case PlanFault::nothing_to_spray: return "must leave something to spray";
    case PlanFault::start_not_workable: return "must lie in a workable cell";
    case PlanFault::direction_unsupported: return "must be one of 0, 90, 180, 270 on a grid";
    case PlanFault::out_of_reach:
      return "must reach the field: each place from some station, there and back on one pack";
    case PlanFault::tank_too_small: return "must let a tank last for one cell";
    case PlanFault::swaths_differ: return "must be one for all";
    case PlanFault::margin_too_wide: return "must leave land to fly over";
    case PlanFault::too_many_rows: return "must cut the field into fewer rows";
    case PlanFault::window_too_short: return "must leave the fleet time for all of the field";
    case PlanFault::hours_too_short: return "must leave time for the services planned there";
    case PlanFault::kept_out: return "must leave the field, stations, starts and way points free";
    case PlanFault::ceiling_too_low: return "must let ferries over the ground on their way";
  }
  return "must allow a plan";
}

// The station or the UAV at that place.
std::string stand_key(const PlanError& error, const Scenario& s) {
  const auto is_there = [&](FieldPoint p) { return error.at && p == *error.at; };
  for (std::size_t i = 0; i < s.stations.size(); ++i) {
    if (is_there(s.stations[i].position)) return s.source.stations[i] + ".position_m";
  }
  for (std::size_t i = 0; i < s.uavs.size(); ++i) {
    if (is_there(s.uavs[i].home)) return s.source.uavs[i] + ".start_m";
  }
  return "supply";
}

// The volume around that axis.
std::string volume_key(const PlanError& error, const Scenario& s) {
  const auto& volumes = s.terrain->keep_out;
  const auto found = std::find_if(volumes.begin(), volumes.end(), [&](const planner::KeepOut& v) {
    return error.at == at_m(v.x_m, v.y_m);
  });
  return fmt::format("terrain.keep_out[{}].center_m", found - volumes.begin());
}

// Of the first aircraft whose window ends.
std::string window_key(const Scenario& s) {
  std::size_t u = 0;
  while (u + 1 < s.uavs.size() && !s.uavs[u].available_until) ++u;
  return s.source.uavs[u] + ".available_until_s";
}

// Of the station at that place.
std::string hours_key(const PlanError& error, const Scenario& s) {
  std::size_t i = 0;
  while (i + 1 < s.stations.size() && s.stations[i].position != error.at) ++i;
  return s.source.stations[i] + ".available_until_s";
}

std::string land_key(const Scenario& s) {
  return s.source.lines.contains("field.file") ? "field.file" : "field.boundary_m";
}

std::string key_of(const PlanError& error, const Scenario& s) {
  switch (error.fault) {
    case PlanFault::field_invalid: return land_key(s);
    case PlanFault::start_not_workable: return "field.start_m";
    case PlanFault::direction_unsupported: return "field.work_direction_deg";
    case PlanFault::out_of_reach: return stand_key(error, s);
    case PlanFault::tank_too_small:
      return s.source.uavs.front() + (s.source.lines.contains(s.source.uavs.front() + ".rate_l_ha")
                                          ? ".rate_l_ha"
                                          : ".spray_endurance_s");
    case PlanFault::margin_too_wide: return "field.coverage.margin_m";
    case PlanFault::window_too_short: return window_key(s);
    case PlanFault::hours_too_short: return hours_key(error, s);
    case PlanFault::kept_out: return volume_key(error, s);
    case PlanFault::ceiling_too_low: return "terrain.ceiling_m";
    case PlanFault::nothing_to_spray:
    case PlanFault::swaths_differ:
    case PlanFault::too_many_rows: return s.source.uavs.front() + ".swath_m";
  }
  return "field";
}

// Of the key, or of the map around it that the file has.
int line_of(std::string key, const Source& source) {
  for (;;) {
    if (const auto found = source.lines.find(key); found != source.lines.end()) {
      return found->second;
    }
    const auto dot = key.rfind('.');
    if (dot == std::string::npos) return 1;
    key.resize(dot);
  }
}

}  // namespace

ScenarioError located(const planner::PlanError& error, const Scenario& scenario) {
  const std::string key = key_of(error, scenario);
  std::string value = error.detail;
  if (error.at) value += "; " + place(*error.at, scenario.datum);
  return {.file = scenario.source.file,
          .line = line_of(key, scenario.source),
          .column = 1,
          .key = key,
          .rule = rule_of(error.fault),
          .value = std::move(value)};
}

}  // namespace furrow::mission
