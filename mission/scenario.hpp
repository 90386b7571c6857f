#pragma once
// A scenario as values: what a scenario file says, checked and completed. Nothing here knows YAML.

#include "core/field.hpp"
#include "core/link.hpp"
#include "core/station.hpp"
#include "core/vehicle.hpp"
#include "core/weather.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace furrow::mission {

/// Spec of the coverage route on a grid of square cells as wide as the swath.
struct Coverage {
  Length margin;                   ///< Inset from boundary and holes, >= 0.
  double straight_reward;          ///< S > 1 of the probability walk.
  double turn_reward;              ///< U > S of the probability walk.
  std::uint32_t min_region_cells;  ///< Smaller unvisited regions are reported missed, >= 1.
};

/// How return points are chosen.
enum class ReturnStrategy { unplanned, simple, gsa, exact };

struct Solver {
  ReturnStrategy returns;
  bool refine;               ///< Local refinement after GSA.
  bool paper_counting;       ///< The paper's counting of straight moves, `unplanned` only.
  std::uint32_t iterations;  ///< Of GSA.
  std::uint32_t agents;      ///< Masses of GSA.
  double
      budget_s;  ///< Upper limit, spent as a fixed count of work so that load cannot change a plan.
};

/// What goes wrong, and when. A fault unknown to this build is an input error.
struct Fault {
  enum class Kind { agent_kill };
  Instant at;
  Kind kind;
  AgentId target;
};

/// A figure of the result and where it must lie.
struct Expectation {
  std::string key;  ///< As in result.json, e.g. "missed_m2"; "completed" is 0 or 1.
  std::optional<double> min, max;
};

struct Scenario {
  std::string name;
  std::uint64_t seed;
  Field field;
  std::optional<double> work_direction_deg;  ///< Clockwise from north; searched when left out.
  std::optional<FieldPoint> start;           ///< Chosen when left out.
  Coverage coverage;
  std::vector<Station> stations;  ///< At least one, ids rising.
  std::vector<Vehicle> uavs;      ///< At least one, ids 1, 2, ... in file order.
  Wind wind;
  Solver solver;
  Link link;
  Duration agent_lease;       ///< An agent silent for longer is lost.
  Duration mission_limit;     ///< The run is given up after this mission time.
  std::vector<Fault> faults;  ///< In order of time.
  std::vector<Expectation> expectations;
};

/// The stable name used in scenario files and results.
constexpr const char* name(ReturnStrategy s) {
  switch (s) {
    case ReturnStrategy::unplanned: return "unplanned";
    case ReturnStrategy::simple: return "simple";
    case ReturnStrategy::gsa: return "gsa";
    case ReturnStrategy::exact: return "exact";
  }
  return "unknown";
}

}  // namespace furrow::mission
