#pragma once

#include "agents/conduct/surroundings.hpp"
#include "core/ids.hpp"
#include "core/station.hpp"
#include "core/surprise.hpp"
#include "core/time.hpp"
#include "core/vehicle.hpp"
#include "core/weather.hpp"
#include "planner/ferry/ferry_map.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace furrow::agents {

/// How an aircraft flies where it shares the air: it claims each way that is not work, and
/// over level land flies it at a height of its own.
struct AirspaceRule {
  Length layer{};  ///< Above the height of work; over terrain the layer of the relief counts.
  planner::HeightRule climbs{.climb_energy_s_per_m = 0.0};  ///< Over level land.
};

/// Everything an agent knows before its first message.
struct AgentSettings {
  Vehicle vehicle;
  std::vector<Station> stations;      ///< Those it may be sent to.
  Wind wind;                          ///< The same mean for all; its gusts are this aircraft's own.
  planner::FerryMap ferries{};        ///< The fleet's, for ways of its own.
  AvoidanceRule avoidance{};          ///< Of obstacles seen in flight.
  std::vector<Surprise> surprises{};  ///< What stands there to be seen.
  std::optional<AirspaceRule> airspace{};  ///< None: it has the air to itself.
  std::uint64_t seed;                      ///< Of the scenario.
  BootId boot;
  Duration info_period{2'000'000'000};      ///< Until a command arrives.
  Duration report_period{2'000'000'000};    ///< Until a closure is booked.
  Duration scheduler_lease{5'000'000'000};  ///< A scheduler silent for longer is taken for lost.
};

}  // namespace furrow::agents
