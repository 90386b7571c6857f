#pragma once
// A scenario as values: what a scenario file says, checked and completed. Nothing here knows YAML.

#include "core/field.hpp"
#include "core/link.hpp"
#include "core/station.hpp"
#include "core/surprise.hpp"
#include "core/vehicle.hpp"
#include "core/weather.hpp"
#include "exchange/local_frame.hpp"
#include "planner/coverage/cover.hpp"
#include "planner/returns/solve.hpp"
#include "planner/survey/survey.hpp"
#include "planner/terrain/relief.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace furrow::mission {

/// What goes wrong or the operator orders, and when. One unknown to this build is an input error.
struct Fault {
  enum class Kind {
    agent_kill,  ///< It falls silent for good.
    agent_join,  ///< It is not there before.
    bay_down,    ///< Takes nobody more; who is in it is served to the end.
    pause,       ///< The operator's orders from here on.
    resume,
    return_all,
    stop,
    take_out,  ///< The only one with a target.
  };
  Instant at;
  Kind kind;
  NodeId target;          ///< An agent, the station of the bay, or the scheduler, who takes orders.
  std::uint32_t bay = 0;  ///< 0: all of the station.
};

/// As scenarios and results call them.
inline constexpr std::array fault_names{"agent_kill", "agent_join", "bay_down", "pause",
                                        "resume",     "return_all", "stop",     "take_out"};
constexpr const char* name(Fault::Kind kind) { return fault_names[static_cast<std::size_t>(kind)]; }

/// A figure of the result and where it must lie.
struct Expectation {
  std::string key;  ///< As in result.json, e.g. "missed_m2"; "completed" is 0 or 1.
  std::optional<double> min, max;
};

/// Where a scenario says what it says.
struct Source {
  std::string file;
  std::map<std::string, int> lines;         ///< Of every key: "uavs[0].swath_m".
  std::vector<std::string> stations, uavs;  ///< The entry of each, as in the scenario: "uavs[0]".
};

/// Share of the narrowest swath that the separation of several aircraft may be at most: so far
/// apart those are that work on neighbouring strips, whatever their error.
inline constexpr double widest_separation = 0.75;

struct Scenario {
  std::string name;
  std::uint64_t seed;
  Field field;
  std::optional<Area> stated_area;           ///< Of the field, as its file says.
  std::optional<double> work_direction_deg;  ///< Clockwise from north; searched when left out.
  std::optional<FieldPoint> start;           ///< Chosen when left out.
  std::optional<exchange::Datum> datum;      ///< Where on the globe the frame's origin lies.
  planner::CoverageModel coverage;           ///< Direction and start are the lines above.
  std::vector<Station> stations;             ///< At least one, ids rising.
  std::vector<Surprise> surprises;           ///< Obstacles that the plan does not know.
  std::vector<Vehicle> uavs;                 ///< At least one, ids 1, 2, ... in file order.
  Wind wind;
  std::optional<planner::TerrainModel> terrain;   ///< None: level, and heights are not flown.
  std::optional<planner::SurveySettings> survey;  ///< None: the field is sprayed.
  planner::SolveSettings solver;                  ///< Its seed is the scenario's.
  Link link;
  Duration agent_lease;       ///< An agent silent for longer is lost.
  Duration mission_limit;     ///< The run is given up after this mission time.
  Length separation;          ///< Nearer than this two aircraft in the air do not come.
  std::vector<Fault> faults;  ///< In order of time.
  std::vector<Expectation> expectations;
  Source source;
  /// What was mended or looks wrong, "FILE:LINE: KEY: warning: SENTENCE" each, by line.
  std::vector<std::string> warnings;
};

}  // namespace furrow::mission
