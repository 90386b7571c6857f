#pragma once
// The course that every command that makes results takes: load, plan, fly, judge, write, tell.

#include "app/options.hpp"
#include "app/results/mission_record.hpp"
#include "app/results/terminal.hpp"
#include "planner/plan_error.hpp"
#include "sim/simulate.hpp"

#include <functional>
#include <string>

namespace furrow::app {

/// How far a mission has come, drawn on the terminal while it flies.
class Progress {
 public:
  /// @param shown  Whether anything is drawn at all.
  Progress(const scheduler::FleetPlan& plan, bool shown);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void observe(const Envelope& envelope);

 private:
  ProgressBar bar_;
  double started_s_;
};

/// A mission flown.
struct Flight {
  sim::Log log;
  bool broken_off;                   ///< Before its end, by an interrupt or a failure.
  std::vector<std::string> mishaps;  ///< Sentences for the operator: processes that died, ...
};

/// Flies a plan that took `planned_s` to make. What fails on the way ends the flight as broken off,
/// with a mishap that says why.
///
/// @error  A sentence about the environment; nothing has been flown then.
using Fly = std::function<Expected<Flight, std::string>(
    const mission::Scenario&, const scheduler::FleetPlan&, double planned_s, Progress&)>;

/// Where the results go.
std::string results_folder(const Options& options, const mission::Scenario& scenario);

/// Loads the scenario of `options`; on bad input says every error on stderr, otherwise
/// every warning.
///
/// @return  The scenario with the seed asked for, or the exit code.
Expected<mission::Scenario, Exit> load(const Options& options);

/// Says on stderr why there is no plan.
void tell(const planner::PlanError& error, const mission::Scenario& scenario);

/// An interrupt while the plan is made lets it end first and is then obeyed: the results hold the
/// plan and are partial. A second one ends the process there and then, with nothing written.
///
/// @param fly  Left out: plan only.
/// @return  The exit code.
int conduct(const Options& options, Mode mode, const Fly& fly = {});

}  // namespace furrow::app
