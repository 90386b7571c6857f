#pragma once
// The figures of a mission, as result.json holds them. Units end the names, because the names are
// the file's.

#include "app/results/mission_record.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace furrow::app {

struct FieldFigures {
  double area_m2;                        ///< Inside the boundary and outside the holes.
  std::optional<double> stated_area_m2;  ///< As the field's file says.
  std::uint32_t strips;
  double strip_length_m;
  std::uint32_t cells;  ///< Workable cells, those that the route leaves out included.
};

/// On a grid the ledger's view, in whole cells: covered and missed together are all workable cells.
/// On a swept field the true areas of all that the booms wetted, but for the last two. Forecasts
/// when only planned.
struct CoverageFigures {
  double covered_m2;    ///< On a grid proven by a closed grant.
  double missed_m2;     ///< Workable land left dry.
  double repeated_m2;   ///< Sprayed more than once, each extra pass counted.
  double outside_m2;    ///< Sprayed outside the boundary or inside a hole.
  double unrouted_m2;   ///< Part of missed: left out by the route.
  double abandoned_m2;  ///< Part of missed: given up by the scheduler.
  double uncertain_m2;  ///< Part of missed: truly sprayed, without proof.
};

/// What the swaths wetted: on a grid from the true offset of each cell's pass, on swept fields from
/// the union of the true tracks' footprints. When only planned, of the strips flown exactly.
struct FootprintFigures {
  double wetted_m2;
  double missed_m2;   ///< Workable land left dry.
  double overlap_m2;  ///< Area wetted again.
  double outside_m2;  ///< Wetted outside the boundary or inside a hole.
};

struct FleetFigures {
  double makespan_s;  ///< Mission time of the last sprayed cell.
  double planned_makespan_s;
  /// The same where aircraft that leave one place take off one by one; none where they need not.
  std::optional<double> planned_in_shared_air_s;
  double lower_bound_s;
  std::string bound;          ///< What holds the fleet up by that bound; empty if nothing is known.
  std::optional<double> gap;  ///< makespan / lower bound - 1, of completed missions with a bound.
  double spray_s, non_spray_s, queue_wait_s;
  double route_m;          ///< At work: strips and the connections between them, sortie by sortie.
  double ferry_m;          ///< On all other ways: from and to stations.
  double flown_outside_m;  ///< Over no land, holes and obstacles included, on all ways.
  double outside_at_work_m;  ///< The part of it that is not on the ways from and to stations.
  double rate_l_ha;          ///< Application rate: the mean over the shares' areas.
  double sprayed_l;   ///< On all ground wetted, each time: rate times footprint, as the next two.
  double repeated_l;  ///< Part of it: on ground wetted again.
  double outside_l;   ///< Part of it: outside the boundary or inside a hole.
};

struct SortieFigures {
  FieldPoint start, returned;
  double spray_m;
  double round_trip_m;  ///< Ferry ways home and on to the next sortie; 0 after the last sortie.
  double flight_s;
  std::uint32_t pack;
  double battery_used;
  double battery_swap_s, fill_s, fill, wait_s;
  std::uint32_t station, bay;  ///< 0 after the last sortie.
  double began_s, spray_began_s, spray_ended_s, landed_s;
  double service_began_s, ready_s;  ///< 0 after the last sortie.
};

struct Spread {
  std::uint64_t samples;
  double rms_m, max_m;
};

/// Cross-track distance on strips: the truth, and what the fix showed of it.
struct DeviationFigures {
  Spread truth, fix;
};

struct UavFigures {
  std::uint32_t id;
  std::uint32_t strips;
  double area_m2;      ///< Its share, planned.
  double non_spray_s;  ///< Round trips, services and waits; the last way home left out.
  double spray_s, queue_wait_s, ferry_m;
  double spray_ended_s, landed_s;
  double planned_spray_ended_s;
  double planned_non_spray_s;  ///< E of the plan, waits left out.
  double lower_bound_s;        ///< Of the planned non-spray time.
  bool proven;
  bool lost;
  DeviationFigures deviation;
  std::vector<SortieFigures> sorties;
};

struct BatteryFigures {
  std::uint32_t uav, pack;
  double used;
};

/// Sums over the fleet's plans.
struct SolverFigures {
  std::string returns;
  bool refined;
  std::uint32_t return_points;
  double round_trips_m;
  std::uint32_t swaps;
  double swap_s, fill_s, service_s;
  double non_spray_s;               ///< Waits left out.
  std::optional<double> gsa_s;      ///< Objective before refinement.
  std::optional<double> optimum_s;  ///< Where every UAV's is proven.
  double lower_bound_s;
  bool proven;
  std::optional<double> gap;            ///< None without a bound.
  std::optional<double> until_empty_s;  ///< Non-spray time of returning when the tank is empty.
  /// Swath model: no plan that returns anywhere along the strips has less; and by how much of its
  /// mission time the plan on whole cells may lie above that, for the aircraft with the most.
  std::optional<double> anywhere_lower_bound_s, anywhere_gap;
  std::uint64_t evaluations;
  double wall_s;
  std::optional<scheduler::Yardsticks> yardsticks;  ///< Where sorties were chosen jointly.
};

struct BayFigures {
  std::uint32_t bay, services;
  double busy_s;
};

struct StationFigures {
  std::uint32_t id, swaps;
  double filled_l;
  std::vector<BayFigures> bays;
  double available_from_s = 0;
  std::optional<double> available_until_s{};
};

struct LogFigures {
  std::uint64_t messages;
  std::string digest;  ///< 64 bits in hexadecimal.
};

struct FaultFigures {
  double at_s;
  std::string kind;
  std::uint32_t target;
  std::optional<double> noticed_s;
};

struct ExpectationFigures {
  std::string key;
  bool met;
  std::optional<double> value;  ///< None where the result has no such figure.
  std::optional<double> min, max;
  std::string message;  ///< Why it is missed; empty when met.
};

/// How near two aircraft in the air came to each other.
struct SeparationFigures {
  double distance_m;  ///< Of the scenario.
  std::uint32_t encounters;
  double near_s;                             ///< Their durations together.
  std::optional<double> closest_m, first_s;  ///< None without one.
};

/// How near an aircraft came to an obstacle.
struct ClearanceFigures {
  std::uint32_t uav;
  std::string obstacle;
  double least_m;  ///< From its edge.
  double share;    ///< Of the safety distance.
  double at_s;
};

/// What the operator wanted at the end.
struct OperatorFigures {
  std::string level;  ///< "fly" unless ordered otherwise.
  std::vector<std::uint32_t> taken_out;
};

/// Of a survey.
struct SurveyFigures {
  std::uint32_t way_points;
  std::uint32_t visited;    ///< Proven by a closed grant; planned when only planned.
  std::uint32_t uncertain;  ///< Passed in truth, without proof.
};

/// Obstacles that the plan did not know.
struct MetFigures {
  std::size_t obstacles = 0;
  std::size_t detours = 0, closed = 0;  ///< Ways around them flown, valve open and valve closed.
  std::size_t blocked = 0;              ///< Holds for want of one.
};

struct Result {
  std::string scenario;
  std::uint64_t seed;
  Mode mode;
  bool partial;
  bool completed;  ///< Every cell of the route is sprayed, or is planned to be.
  FieldFigures field;
  std::optional<exchange::Datum> datum;        ///< Where on the globe the field frame lies.
  std::optional<planner::SweepFigures> sweep;  ///< As of planner::Coverage.
  MetFigures met;
  std::optional<SurveyFigures> survey;  ///< Then there is nothing to cover.
  CoverageFigures coverage;
  FootprintFigures footprint;
  FleetFigures fleet;
  std::vector<UavFigures> uavs;
  std::vector<BatteryFigures> batteries;
  SolverFigures solver;
  DeviationFigures deviation;
  std::vector<StationFigures> stations;
  std::vector<std::string> warnings;  ///< See app/results/warnings.hpp.
  std::vector<Violation> violations;
  LogFigures log;
  Timing timing;
  double real_time_factor;
  std::vector<FaultFigures> faults;
  OperatorFigures ordered;
  SeparationFigures separation;
  std::optional<ClearanceFigures> clearance{};  ///< None without obstacles or tracks.
  std::vector<ExpectationFigures> expectations;
};

}  // namespace furrow::app
