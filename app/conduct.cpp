#include "app/conduct.hpp"

#include "app/interrupt.hpp"
#include "app/results/result_json.hpp"
#include "app/results/summary.hpp"
#include "app/results/write_results.hpp"
#include "mission/fleet.hpp"
#include "mission/load.hpp"
#include "mission/located.hpp"
#include "scheduler/plan_fleet.hpp"
#include "sim/checkers/laws.hpp"

#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <map>
#include <unistd.h>

namespace furrow::app {
namespace {

double wall_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void tell(const std::string& sentence) { fmt::print(stderr, "furrow: {}\n", sentence); }

std::vector<sim::Violation> judged(const MissionRecord& record, const Flight& flight) {
  const sim::Facts facts{.field = record.scenario.field,
                         .stations = record.scenario.stations,
                         .plan = record.plan,
                         .claim_lease = record.scenario.agent_lease,
                         .whole = flight.log.finished,
                         .wind = record.scenario.wind,
                         .surprises = record.scenario.surprises,
                         .separation = record.scenario.separation};
  return sim::violations(facts, record.log, flight.log.ended);
}

// Neither what every flight of the route leaves dry, nor what cells given up hold of obstacles.
double not_sprayed_m2(const CoverageFigures& c) {
  const double more_m2 = c.missed_m2 - c.unrouted_m2;
  return c.abandoned_m2 > 0 ? std::min(more_m2, c.abandoned_m2) : more_m2;
}

// What keeps a mission from exit code 0, in sentences.
std::vector<std::string> shortcomings(const Result& result, const std::vector<Envelope>& log) {
  std::vector<std::string> all;
  if (result.partial) all.emplace_back("the mission was broken off; the results are partial");
  if (!result.completed && result.survey) {
    all.push_back(fmt::format("the mission is not completed: {} of {} way points are not visited",
                              result.survey->way_points - result.survey->visited,
                              result.survey->way_points));
  } else if (!result.completed) {
    all.push_back(fmt::format("the mission is not completed: {:.0f} m2 are not sprayed",
                              not_sprayed_m2(result.coverage)));
  }
  for (const Envelope& envelope : log) {
    const auto* const event = std::get_if<Event>(&envelope.body);
    if (event == nullptr) continue;
    if (event->kind == "mission_limit") all.push_back(event->detail);
    if (event->kind == "mission_stopped") {
      all.push_back(fmt::format("the operator stopped the mission at {:.1f} s",
                                seconds(envelope.sent).base()));
    }
  }
  for (const auto& expectation : result.expectations) {
    if (!expectation.met) all.push_back("expectation missed: " + expectation.message);
  }
  for (const Violation& v : result.violations) {
    all.push_back(
        fmt::format("law {} broken at {:.1f} s: {}", v.law, seconds(v.at).base(), v.detail));
    if (all.size() > 20) break;
  }
  return all;
}

// What went wrong and was made good, or could not be, in sentences.
std::vector<std::string> losses(const std::vector<Envelope>& log) {
  std::vector<std::string> all;
  for (const Envelope& envelope : log) {
    const auto* const event = std::get_if<Event>(&envelope.body);
    if (event == nullptr) continue;
    const double at_s = seconds(envelope.sent).base();
    if (event->kind == "agent_lost") {
      all.push_back(fmt::format("lost at {:.1f} s: {}", at_s, event->detail));
    }
    if (event->kind == "bay_down" || event->kind == "not_served" ||
        event->kind == "agent_taken_out" || event->kind == "order_refused") {
      all.push_back(fmt::format("at {:.1f} s: {}", at_s, event->detail));
    }
    if (event->kind == "cells_uncertain") {
      all.push_back(fmt::format("uncertain since {:.1f} s: {}", at_s, event->detail));
    }
  }
  return all;
}

// Why cells or way points were given up, each reason once.
std::vector<std::string> given_up(const std::vector<Envelope>& log, const char* what) {
  struct Times {
    double first_s;
    int runs = 0;
  };
  std::map<std::string, Times> by_reason;
  for (const Envelope& envelope : log) {
    const auto* const event = std::get_if<Event>(&envelope.body);
    if (event == nullptr || event->kind != "cells_abandoned") continue;
    const std::size_t colon = event->detail.find(": ");
    if (colon == std::string::npos) continue;
    const std::string reason = event->detail.substr(colon + 2);
    const auto entry = by_reason.try_emplace(reason, Times{seconds(envelope.sent).base()}).first;
    ++entry->second.runs;
  }
  std::vector<std::string> all;
  all.reserve(by_reason.size());
  for (const auto& [reason, times] : by_reason) {
    all.push_back(fmt::format("given up since {:.1f} s, {} {} of {}: {}", times.first_s, times.runs,
                              times.runs == 1 ? "run" : "runs", what, reason));
  }
  return all;
}

int report(const Options& options, const MissionRecord& record) {
  const Result result = summary(record);
  const std::string folder = results_folder(options, record.scenario);
  if (const auto written = write_results(folder, record, result); !written) {
    tell(text(written.error()));
    return Exit::bad_input;
  }
  if (options.json) fmt::print("{}", result_json(result));
  if (!options.quiet) {
    fmt::print(stderr, "{}", summary_table(result));
    fmt::print(stderr, "Results: {}/report.html\n", folder);
  }
  for (const std::string& sentence : result.warnings) tell(sentence);
  for (const std::string& sentence : losses(record.log)) tell(sentence);
  const char* given = result.survey ? "way points" : "cells";
  for (const std::string& sentence : given_up(record.log, given)) tell(sentence);
  const auto lacking = shortcomings(result, record.log);
  for (const std::string& sentence : lacking) tell(sentence);
  return lacking.empty() ? Exit::done : Exit::not_met;
}

}  // namespace

Progress::Progress(const scheduler::FleetPlan& plan, bool shown)
    : bar_{static_cast<std::uint32_t>(plan.route.centers.size()), shown}, started_s_{wall_s()} {}

Progress::~Progress() { fmt::print(stderr, "{}", bar_.clear()); }

void Progress::observe(const Envelope& envelope) {
  const auto* state = std::get_if<SchedulerState>(&envelope.body);
  if (state == nullptr) return;
  fmt::print(stderr, "{}",
             bar_.draw(state->sprayed_cells, seconds(envelope.sent).base(), wall_s() - started_s_));
}

std::string results_folder(const Options& options, const mission::Scenario& scenario) {
  return options.out.empty() ? "out/" + scenario.name : options.out;
}

Expected<mission::Scenario, Exit> load(const Options& options) {
  auto scenario = mission::load(options.scenario);
  if (!scenario) {
    for (const auto& error : scenario.error()) fmt::print(stderr, "{}\n", mission::text(error));
    return Unexpected{Exit::bad_input};
  }
  for (const std::string& warning : scenario->warnings) fmt::print(stderr, "{}\n", warning);
  if (options.seed) scenario->seed = scenario->solver.seed = *options.seed;
  return std::move(*scenario);
}

void tell(const planner::PlanError& error, const mission::Scenario& scenario) {
  fmt::print(stderr, "{}\n", mission::text(mission::located(error, scenario)));
}

int conduct(const Options& options, Mode mode, const Fly& fly) {
  auto scenario = load(options);
  if (!scenario) return scenario.error();

  const double started_s = wall_s();
  auto plan = [&] {
    const SecondInterruptEnds nothing_is_lost;
    return scheduler::plan_fleet(mission::fleet_problem(*scenario));
  }();
  if (!plan) {
    tell(plan.error(), *scenario);
    return Exit::bad_input;
  }
  const double planned_s = wall_s();
  MissionRecord record{.scenario = std::move(*scenario),
                       .plan = std::move(*plan),
                       .mode = mode,
                       .partial = is_interrupted(),
                       .log = {},
                       .violations = {},
                       .timing = {.plan_wall_s = planned_s - started_s,
                                  .run_wall_s = 0.0,
                                  .solver_wall_s = planned_s - started_s}};
  if (fly && !record.partial) {
    auto flight = [&] {
      Progress progress{record.plan, !options.quiet && isatty(STDERR_FILENO) == 1};
      return fly(record.scenario, record.plan, planned_s - started_s, progress);
    }();
    if (!flight) {
      tell(flight.error());
      return Exit::bad_input;
    }
    for (const std::string& mishap : flight->mishaps) tell(mishap);
    record.timing.run_wall_s = wall_s() - planned_s;
    record.partial = flight->broken_off;
    record.log = std::move(flight->log.envelopes);
    record.violations = judged(record, *flight);
  }
  return report(options, record);
}

}  // namespace furrow::app
