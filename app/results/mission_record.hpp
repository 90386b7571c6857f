#pragma once

#include "core/messages.hpp"
#include "mission/scenario.hpp"
#include "scheduler/fleet_plan.hpp"
#include "sim/checkers/violation.hpp"

#include <cstdint>
#include <vector>

namespace furrow::app {

using sim::Violation;

/// How a mission came about.
enum class Mode : std::uint8_t {
  plan,  ///< Planned only: all figures are forecasts.
  sim,   ///< Flown on a virtual clock in one process.
  run,   ///< Flown by a process per node.
};

/// The stable name used in results.
constexpr const char* name(Mode mode) {
  switch (mode) {
    case Mode::plan: return "plan";
    case Mode::sim: return "sim";
    case Mode::run: return "run";
  }
  return "unknown";
}

/// Wall-clock time spent [s]. With the mode, all that may differ between equal missions.
struct Timing {
  double plan_wall_s;
  double run_wall_s;     ///< 0 when only planned.
  double solver_wall_s;  ///< Part of planning.
};

/// All that is known of one mission: what every result file is made from.
struct MissionRecord {
  mission::Scenario scenario;
  scheduler::FleetPlan plan;
  Mode mode;
  bool partial;               ///< Interrupted: the log stops before the mission did.
  std::vector<Envelope> log;  ///< By time, sender, sequence number; empty when only planned.
  std::vector<Violation> violations;
  Timing timing;
};

}  // namespace furrow::app
