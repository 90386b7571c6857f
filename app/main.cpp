// The furrow command: reads the command line and hands over to one of app/commands.

#include "app/options.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <exception>
#include <filesystem>

namespace furrow::app {
namespace {

// "max", "wall" or a positive factor of real time.
std::string set_pace(Pace& pace, const std::string& text) {
  if (text == "max") {
    pace = {Pace::Kind::max, 1.0};
  } else if (text == "wall") {
    pace = {Pace::Kind::wall, 1.0};
  } else {
    double factor = 0.0;
    const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), factor);
    const bool is_number = fault == std::errc{} && stop == text.data() + text.size();
    if (!is_number || !(factor >= 0.01 && factor <= 1e6)) {
      return "--speed: max, wall, or times real time, from 0.01 to 1e6 (got " + text + ")";
    }
    pace = {Pace::Kind::times_real, factor};
  }
  return {};
}

// "7" or "3-4", numbers from 1.
std::optional<AgentRange> agent_range(const std::string& text) {
  const char* const end = text.data() + text.size();
  AgentRange range{};
  auto read = std::from_chars(text.data(), end, range.first);
  range.last = range.first;
  if (read.ec == std::errc{} && read.ptr != end && *read.ptr == '-') {
    read = std::from_chars(read.ptr + 1, end, range.last);
  }
  const bool is_range = read.ec == std::errc{} && read.ptr == end;
  if (!is_range || range.first == 0 || range.first > range.last) return std::nullopt;
  return range;
}

// The library takes "-1" for a large number and "+5" or "0x5" for a small one.
const CLI::Validator digits{
    [](const std::string& text) -> std::string {
      std::uint64_t value = 0;
      const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
      const bool is_whole = read.ec == std::errc{} && read.ptr == text.data() + text.size();
      return is_whole ? "" : "must be a whole number below 2^64 (got " + text + ")";
    },
    ""};
const CLI::Validator something{
    [](const std::string& text) -> std::string { return text.empty() ? "must not be empty" : ""; },
    ""};

void add_scenario(CLI::App& command, Options& options) {
  command.add_option("scenario", options.scenario, "Scenario file (YAML)")->required();
  command.add_option("--seed", options.seed, "Instead of the scenario's seed")->check(digits);
}

void add_results(CLI::App& command, Options& options) {
  command.add_option("--out", options.out, "Folder for the results (default out/<scenario name>)")
      ->check(something);
  command.add_flag("--json", options.json, "Print result.json to stdout, and nothing else there");
  command.add_flag("--quiet", options.quiet, "No progress, no summary");
}

// What the command line says in words of its own.
struct Words {
  std::string speed = "max";
  std::string remote_agents;
};

void add_flight(CLI::App& command, Options& options) {
  add_scenario(command, options);
  add_results(command, options);
  command.footer(
      "Ctrl-C keeps the results so far, marked partial (code 1); during planning it waits for "
      "the plan, and a second one ends at once with code 130 and nothing written.");
}

void add_processes(CLI::App& command, Options& options, Words& words) {
  command.add_option("--speed", words.speed,
                     "max, times real time (granted by the clock), or wall (real time)");
  command
      .add_option("--agents-per-process", options.agents_per_process,
                  "Aircraft hosted by one process")
      ->check(digits)
      ->check(CLI::Range(1, 50));
  command.add_option("--interface", options.interface, "Address of the network interface to use");
  command
      .add_option("--remote-agents", words.remote_agents,
                  "Aircraft of another host, 7 or 3-4: prints the commands to start there")
      ->check(something);
  command
      .add_option("--start-in", options.start_in_s, "Seconds until a mission in real time begins")
      ->check(digits)
      ->check(CLI::Range(1, 3600));
}

void add_order(CLI::App& command, Options& options) {
  command.add_option("folder", options.folder, "Where the run will write its results")->required();
  command
      .add_option("order", options.order, "pause, resume, return-all, stop, or take-out with a UAV")
      ->required();
  command.add_option("uav", options.uav, "Number of the UAV to take out");
  command.add_option("--wait", options.patience_s, "Longest wait for the answer [s]")
      ->check(digits)
      ->check(CLI::Range(1, 3600));
  command.footer(
      "Code 0: the fleet obeys; 1: the order is refused, or not answered in time; 2: no such run, "
      "order or UAV.");
}

void add_export(CLI::App& command, Options& options) {
  command.add_option("folder", options.folder, "Results of plan, sim or run")->required();
  command.add_option("--format", options.format, "qgc-plan, waypoints, geojson, kml or csv")
      ->required();
  command.add_option("--out", options.out, "Folder for the files (default FOLDER/export)");
  command.add_flag("--quiet", options.quiet, "Say nothing");
}

// What is wrong with the words, or nothing.
std::string read_words(const Words& words, Options& options) {
  if (std::string error = set_pace(options.pace, words.speed); !error.empty()) return error;
  if (words.remote_agents.empty()) return {};
  options.remote_agents = agent_range(words.remote_agents);
  if (options.remote_agents && options.pace.kind == Pace::Kind::wall) return {};
  return "--remote-agents: must be a number or a range like 3-4, with --speed wall (got " +
         words.remote_agents + ")";
}

using Action = int (*)(const Options&);

// Adds every command, each of which sets `chosen`.
void add_commands(CLI::App& app, Options& options, Words& words, Action& chosen) {
  const auto command = [&](const char* name, const char* about, Action action) -> CLI::App& {
    CLI::App& added = *app.add_subcommand(name, about);
    added.callback([&chosen, action] { chosen = action; });
    return added;
  };
  add_scenario(command("check", "Say every error of a scenario, or why it has no plan", check),
               options);
  CLI::App& planned = command("plan", "Plan only", plan);
  add_scenario(planned, options);
  add_results(planned, options);
  add_flight(command("sim", "Fly in one process on a virtual clock", sim), options);
  CLI::App& flown =
      command("run", "Fly as one process per scheduler, station and agent, over DDS", run);
  add_flight(flown, options);
  add_processes(flown, options, words);
  add_order(command("operate", "Give an order to a run that is going on", operate), options);
  add_export(
      command("export", "Write a mission's sorties for other tools, in WGS84", export_missions),
      options);
}

int furrow(int argc, char** argv) {
  CLI::App app{"Plans and flies crop-spraying missions of several UAVs.", "furrow"};
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::help);
  Options options;
  options.program_folder = std::filesystem::canonical("/proc/self/exe").parent_path();
  Words words;
  Action chosen = nullptr;
  add_commands(app, options, words, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? Exit::done : Exit::bad_input;
  }
  if (const std::string error = read_words(words, options); !error.empty()) {
    std::fprintf(stderr, "furrow: %s\n", error.c_str());
    return Exit::bad_input;
  }
  return chosen(options);
}

}  // namespace
}  // namespace furrow::app

int main(int argc, char** argv) {
  try {
    return furrow::app::furrow(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "furrow: internal error: %s\n", error.what());
    return furrow::app::Exit::broken;
  }
}
