#include "mission/checks.hpp"

#include "mission/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace furrow::mission {
namespace {

void check_start(const Section& field, const Scenario& s) {
  if (!s.start) return;
  const bool in_hole = std::any_of(s.field.holes.begin(), s.field.holes.end(),
                                   [&](const Ring& h) { return is_inside(*s.start, h); });
  if (!is_inside(*s.start, s.field.boundary) || in_hole) {
    field.fail("start_m", "must lie inside the boundary and outside the holes", text(*s.start));
  }
}

void check_swaths(const Draft& draft) {
  const auto& uavs = draft.scenario.uavs;
  for (std::size_t i = 1; i < uavs.size(); ++i) {
    const bool is_first_of_entry = draft.fleet_of[i] != draft.fleet_of[i - 1];
    if (is_first_of_entry && uavs[i].swath != uavs[0].swath) {
      draft.fleets[draft.fleet_of[i]].fail(
          "swath_m", fmt::format("must equal that of uavs[0], {:.10g}: one route serves all",
                                 uavs[0].swath.base()));
    }
  }
}

void check_overlap(const Section& coverage, const Draft& draft) {
  const auto* swath = std::get_if<planner::SwathSettings>(&draft.scenario.coverage);
  if (!swath || !swath->row_overlap) return;
  const Length most = 0.5 * draft.scenario.uavs[0].swath;
  if (*swath->row_overlap <= most) return;
  coverage.fail("row_overlap_m",
                fmt::format("must be at most half the swath, {:.10g}", most.base()));
}

// Keeps a grid over the field within memory.
void check_cells(const Draft& draft) {
  if (!std::holds_alternative<planner::CoverageSettings>(draft.scenario.coverage)) return;
  constexpr double most_cells = 10e6;
  double low_x = 1e9, low_y = 1e9, high_x = -1e9, high_y = -1e9;
  for (const FieldPoint p : draft.scenario.field.boundary) {
    low_x = std::min(low_x, p.x.base());
    high_x = std::max(high_x, p.x.base());
    low_y = std::min(low_y, p.y.base());
    high_y = std::max(high_y, p.y.base());
  }
  const double swath_m = draft.scenario.uavs[0].swath.base();
  if ((high_x - low_x) * (high_y - low_y) / (swath_m * swath_m) > most_cells) {
    draft.fleets[0].fail("swath_m", fmt::format("must cut the field's {:.10g} x {:.10g} m into at "
                                                "most {:.10g} cells",
                                                high_x - low_x, high_y - low_y, most_cells));
  }
}

void check_separation(const Section& limits, const Draft& draft) {
  const auto& uavs = draft.scenario.uavs;
  Length narrowest = uavs[0].swath;
  for (const Vehicle& v : uavs) narrowest = std::min(narrowest, v.swath);
  const Length most = widest_separation * narrowest;
  if (uavs.size() < 2 || draft.scenario.separation <= most) return;
  limits.fail(
      "separation_m",
      fmt::format("must be at most {:.10g}, three quarters of the narrowest swath: aircraft "
                  "on neighbouring strips come as near as that",
                  most.base()));
}

// Whether a UAV gets from the station to the nearest ground of the field and back on one pack.
bool reaches(const Vehicle& v, Length away) {
  return 2.0 * away / v.ferry_speed <= usable_endurance(v);
}

void check_reach(const Draft& draft) {
  const auto& s = draft.scenario;
  std::vector<Length> away;
  std::vector<bool> is_reached(s.stations.size());
  for (const auto& station : s.stations) {
    away.push_back(distance(station.position, s.field.boundary));
  }
  std::vector<bool> gets_there(draft.fleets.size());
  for (std::size_t u = 0; u < s.uavs.size(); ++u) {
    for (std::size_t k = 0; k < away.size(); ++k) {
      if (!reaches(s.uavs[u], away[k])) continue;
      is_reached[k] = true;
      gets_there[draft.fleet_of[u]] = true;
    }
  }
  for (std::size_t k = 0; k < away.size(); ++k) {
    if (is_reached[k]) continue;
    draft.stations[k].fail("position_m",
                           "must be within reach of the field: there and back on one pack",
                           fmt::format("{:.10g} m away", away[k].base()));
  }
  const bool any = std::any_of(is_reached.begin(), is_reached.end(), [](bool b) { return b; });
  for (std::size_t i = 0; any && i < gets_there.size(); ++i) {
    if (gets_there[i]) continue;
    draft.fleets[i].fail("flight_endurance_s", "must last from some station to the field and back");
  }
}

// Stations that would serve nobody within the mission.
void check_hours(const Draft& draft) {
  const std::vector<Station>& stations = draft.scenario.stations;
  const Seconds longest = seconds(draft.scenario.mission_limit);
  for (std::size_t k = 0; k < stations.size(); ++k) {
    const Station& s = stations[k];
    const Seconds service = service_time(s, true, 0.0);
    if (s.available_from >= longest) {
      draft.stations[k].fail("available_from_s",
                             fmt::format("must be earlier than limits.mission_s, {:.10g}: it "
                                         "never opens",
                                         longest.base()));
    } else if (s.available_until && s.available_from < *s.available_until &&
               !keeps(s, s.available_from, service)) {
      draft.stations[k].fail(
          "available_until_s",
          fmt::format("must be later than available_from_s by a swap of packs at least, {:.10g} s",
                      service.base()));
    }
  }
}

void check_joins(const Draft& draft) {
  std::set<NodeId> joining;
  for (std::size_t i = 0; i < draft.faults.size(); ++i) {
    const Fault& fault = draft.scenario.faults[i];
    if (fault.kind != Fault::Kind::agent_join) continue;
    if (!joining.insert(fault.target).second) {
      draft.faults[i].fail("target", "must join once only");
    } else if (joining.size() == draft.scenario.uavs.size()) {
      draft.faults[i].fail("target", "must leave a UAV to begin with");
    }
  }
}

void check_agent_faults(const Draft& draft) {
  const auto uavs = draft.scenario.uavs.size();
  for (std::size_t i = 0; i < draft.faults.size(); ++i) {
    const Fault& fault = draft.scenario.faults[i];
    if (fault.target.kind != NodeKind::agent || fault.target.number <= uavs) continue;
    draft.faults[i].fail("target", fmt::format("must be the id of a UAV, 1 to {}", uavs));
  }
}

void check_station_faults(const Draft& draft) {
  const std::vector<Station>& stations = draft.scenario.stations;
  for (std::size_t i = 0; i < draft.faults.size(); ++i) {
    const Fault& fault = draft.scenario.faults[i];
    if (fault.target.kind != NodeKind::station) continue;
    const auto station = std::find_if(stations.begin(), stations.end(),
                                      [&](const Station& s) { return node(s.id) == fault.target; });
    if (station == stations.end()) {
      draft.faults[i].fail("target", "must be the id of a station");
    } else if (fault.bay > station->bays) {
      draft.faults[i].fail("bay",
                           fmt::format("must be a bay of the station, 1 to {}", station->bays));
    }
  }
}

// How far ahead an aircraft at ferry speed must see what it stops before.
Length stopping_way(const Vehicle& v) {
  constexpr double reaction_s = 0.3;
  return v.ferry_speed * seconds(reaction_s) +
         v.ferry_speed * v.ferry_speed / (2.0 * planned_acceleration(v));
}

void check_sight(const ObstacleEntry& entry, const Surprise& surprise, const Draft& draft,
                 Length safety) {
  Length least{};
  for (const Vehicle& v : draft.scenario.uavs) least = std::max(least, stopping_way(v) + safety);
  if (surprise.seen_within >= least) return;
  entry.at.fail(entry.sight_key,
                fmt::format("{}must be at least {:.10g}: the safety distance, and the "
                            "way in which an aircraft stops from its ferry speed",
                            entry.value.empty() ? "" : "seen_within_m ",
                            std::ceil(10.0 * least.base()) / 10.0),
                entry.value);
}

// Obstacles that the plan knows, where nobody could stand.
void check_obstacles(const Draft& draft) {
  const Scenario& s = draft.scenario;
  const Length safety = s.survey && s.terrain ? Length{} : planner::safety_of(s.coverage);
  for (std::size_t i = 0; i < draft.obstacles.size(); ++i) {
    const ObstacleEntry& entry = draft.obstacles[i];
    if (!entry.at.has(entry.place_key)) continue;
    for (const Station& station : s.stations) {
      const Length away = -depth_in(s.field.obstacles[i], station.position);
      if (away >= safety) continue;
      const std::string what =
          away > Length{} ? fmt::format("{:.10g} m from", away.base()) : "inside";
      entry.at.fail(entry.place_key, "must leave every station free by the safety distance",
                    fmt::format("{}station {} is {} obstacle {}, {:.10g} m are kept",
                                entry.value.empty() ? "" : entry.value + ": ", number(station.id),
                                what, s.field.obstacles[i].id, safety.base()));
    }
  }
}

// Obstacles that the plan does not know.
void check_surprises(const Draft& draft) {
  const Scenario& s = draft.scenario;
  const auto& avoidance = planner::avoidance_of(s.coverage);
  for (std::size_t i = 0; i < draft.surprises.size(); ++i) {
    const ObstacleEntry& entry = draft.surprises[i];
    if (!avoidance) {
      entry.at.fail(entry.sight_key,
                    "needs field.coverage.avoidance: how aircraft keep away from it", entry.value);
      continue;
    }
    check_sight(entry, s.surprises[i], draft, avoidance->safety);
    const Length kept = s.surprises[i].obstacle.radius + avoidance->safety + metres(1);
    for (const Station& station : s.stations) {
      const Length away = distance(station.position, s.surprises[i].obstacle.center);
      if (away > kept) continue;
      entry.at.fail(
          entry.place_key, "must leave every station free by the safety distance and 1 m",
          fmt::format("station {} is {:.10g} m from the obstacle's axis, {:.10g} m are kept",
                      number(station.id), away.base(), kept.base()));
    }
  }
}

}  // namespace

void check_together(const Section& root, const Draft& draft) {
  const bool field = draft.field_in_order, fleet = draft.fleet_in_order;
  if (field) check_start(root.section("field"), draft.scenario);
  if (fleet) check_swaths(draft);
  if (fleet) check_separation(root.section("limits"), draft);
  if (field && fleet) check_overlap(root.section("field").section("coverage"), draft);
  if (field && fleet) check_cells(draft);
  if (field && fleet && draft.supply_in_order) check_reach(draft);
  if (field && draft.supply_in_order) check_obstacles(draft);
  if (field && fleet && draft.supply_in_order) check_surprises(draft);
  if (fleet && draft.faults_in_order) check_agent_faults(draft);
  if (draft.supply_in_order) check_hours(draft);
  if (draft.supply_in_order && draft.faults_in_order) check_station_faults(draft);
  if (fleet && draft.faults_in_order) check_joins(draft);
}

}  // namespace furrow::mission
