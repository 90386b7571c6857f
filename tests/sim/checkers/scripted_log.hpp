#pragma once
// Logs written by hand, for the laws to judge.

#include "sim/checkers/laws.hpp"

#include <map>
#include <string>
#include <vector>

namespace furrow::sim {

inline constexpr AgentId one{1}, two{2};
inline constexpr StationId depot{1};

inline Instant at(double s) { return instant(seconds(s)); }

inline Vehicle vehicle(AgentId id) {
  return {.id = id,
          .home = at_m(0, 0),
          .swath = metres(2),
          .spray_speed = metres_per_second(3),
          .ferry_speed = metres_per_second(6),
          .spray_endurance = seconds(100),
          .flight_endurance = seconds(1000),
          .battery_reserve = 0.1,
          .tank = litres(10),
          .min_turn_radius = metres(0),
          .acceleration_limit = metres_per_second2(3),
          .gnss = {.sigma = metres(0), .bias = metres(0)}};
}

// One strip of four cells along y at x = 1; two aircraft; a station with one bay at the origin.
inline Facts facts() {
  const Station station{.id = depot,
                        .position = at_m(0, 0),
                        .bays = 1,
                        .battery_swap = seconds(60),
                        .fill_base = seconds(20),
                        .fill_full = seconds(60)};
  Facts f{.field = {.boundary = {at_m(0, 0), at_m(2, 0), at_m(2, 8), at_m(0, 8)},
                    .holes = {},
                    .obstacles = {}},
          .stations = {station},
          .plan = {},
          .claim_lease = duration(seconds(3)),
          .whole = true};
  f.plan.route.cell = metres(2);
  f.plan.route.centers = {at_m(1, 1), at_m(1, 3), at_m(1, 5), at_m(1, 7)};
  for (const AgentId id : {one, two}) {
    scheduler::UavPlan uav{};
    uav.vehicle = vehicle(id);
    uav.station = station;
    f.plan.uavs.push_back(uav);
  }
  return f;
}

// A log under construction: numbers and times the messages.
struct Script {
  std::vector<Envelope> log;
  std::map<NodeId, std::uint64_t> seq;
  void say(NodeId from, double s, Body body) { log.push_back({from, ++seq[from], at(s), body}); }
};

inline SchedulerState finished(std::uint32_t sprayed, std::uint32_t abandoned) {
  return {.epoch = Epoch{1},
          .phase = MissionPhase::finished,
          .completed = abandoned == 0,
          .sprayed_cells = sprayed,
          .open_cells = 0,
          .abandoned_cells = abandoned,
          .lost = {}};
}

inline WorkGrant grant(std::uint64_t id, CellRange cells) {
  return {.agent = one,
          .target_boot = BootId{1},
          .epoch = Epoch{1},
          .revision = 1,
          .closed_through = 0,
          .windows = {{id, cells}}};
}

inline FlightRecord flight(CellRange cells) {
  FlightRecord record{};
  record.agent = one;
  record.cells = cells;
  record.offsets_m.assign(cells.count, 0.0F);
  return record;
}

inline WorkReport closure(std::uint64_t id, CellRange cells, std::uint32_t sprayed) {
  return {.agent = one,
          .boot = BootId{1},
          .epoch = Epoch{1},
          .closures = {{id, cells, sprayed, CloseReason::sprayed, at(5)}}};
}

// All four cells granted, sprayed and booked.
inline Script clean_run() {
  Script s;
  s.say(scheduler_node(), 1, grant(1, {0, 4}));
  s.say(node(one), 5, flight({0, 4}));
  s.say(node(one), 5, closure(1, {0, 4}, 4));
  return s;
}

inline std::vector<std::string> broken_laws(const Facts& f, const Script& s) {
  std::vector<std::string> laws;
  for (const Violation& v : violations(f, s.log, at(100))) laws.push_back(v.law);
  return laws;
}

inline ServiceClaim claim(AgentId agent, ClaimStatus status, std::uint64_t token, double first_s) {
  return {.agent = agent,
          .boot = BootId{1},
          .station = depot,
          .claim = 1,
          .first_claimed = at(first_s),
          .status = status,
          .token = token,
          .swap = true,
          .fill = 0.5};
}

inline ServiceGrant bay_one(AgentId agent, std::uint64_t token, double s) {
  return {.agent = agent,
          .station = depot,
          .claim = 1,
          .bay = 1,
          .token = token,
          .starts = at(s),
          .ready = at(s + 60),
          .expires = at(s + 3)};
}

using Laws = std::vector<std::string>;

inline AgentState heard(Phase phase, double battery, FieldPoint position) {
  AgentState state{};
  state.agent = one;
  state.phase = phase;
  state.tank = 0.97;  // 8 m of 300 m are sprayed
  state.battery = battery;
  state.position = position;
  return state;
}

}  // namespace furrow::sim
