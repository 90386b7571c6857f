#include "app/conduct.hpp"
#include "app/fleet_processes.hpp"
#include "app/interrupt.hpp"
#include "app/operator_desk.hpp"
#include "mission/fleet.hpp"
#include "transport/director.hpp"
#include "transport/domain_lock.hpp"

#include <chrono>
#include <fmt/format.h>
#include <unistd.h>

namespace furrow::app {
namespace {

std::int64_t realtime_ns(std::chrono::system_clock::time_point t) {
  return std::chrono::nanoseconds{t.time_since_epoch()}.count();
}

Flight flight(transport::DirectorResult result, const FleetProcesses& processes) {
  using transport::Ending;
  const bool finished = result.ending == Ending::finished;
  Flight flight{.log = {std::move(result.log), result.end, finished},
                .broken_off = result.ending == Ending::interrupted ||
                              result.ending == Ending::abandoned || result.ending == Ending::failed,
                .mishaps = processes.mishaps()};
  if (!result.reason.empty()) flight.mishaps.push_back(std::move(result.reason));
  if (result.malformed_messages > 0) {
    flight.mishaps.push_back(
        fmt::format("{} malformed messages were dropped", result.malformed_messages));
  }
  return flight;
}

// None where another run writes to the same folder, which is said.
void open_desk(std::optional<OperatorDesk>& desk, const Options& options,
               const mission::Scenario& scenario) {
  auto line = OperatorLine::open(results_folder(options, scenario));
  if (line) {
    desk.emplace(std::move(*line), static_cast<std::uint32_t>(scenario.uavs.size()));
  } else {
    fmt::print(stderr, "furrow: {}\n", line.error());
  }
}

// All but what the processes and the operator have to say in it.
transport::DirectorSettings director_settings(const Options& options,
                                              const mission::Scenario& scenario,
                                              const transport::Network& network) {
  transport::DirectorSettings settings{.network = network,
                                       .members = {},
                                       .latency = scenario.link.latency,
                                       .mission_limit = Instant{scenario.mission_limit}};
  if (options.pace.kind == Pace::Kind::times_real) settings.pace = options.pace.factor;
  if (options.pace.kind == Pace::Kind::wall) {
    settings.epoch_realtime_ns =
        realtime_ns(std::chrono::system_clock::now() + std::chrono::seconds{options.start_in_s});
  }
  return settings;
}

// The scheduler makes its plan before it comes, beside all the others that start.
std::chrono::milliseconds time_to_plan_again(double planned_s) {
  constexpr double slower = 5;
  return std::chrono::milliseconds{static_cast<std::int64_t>(1e3 * slower * planned_s)};
}

}  // namespace

int run(const Options& options) {
  catch_interrupts();
  const auto fly = [&](const mission::Scenario& scenario, const scheduler::FleetPlan&,
                       double planned_s, Progress& progress) -> Expected<Flight, std::string> {
    const auto domain = transport::DomainLock::any_free(options.interface);
    if (!domain) return Unexpected{domain.error().what};
    const transport::Network network{
        .domain = domain->domain(),
        .run = fmt::format("{}-{}", scenario.name, getpid()),
        .stations = static_cast<std::uint32_t>(scenario.stations.size()),
        .interface = options.interface};

    transport::DirectorSettings settings = director_settings(options, scenario, network);
    auto processes = FleetProcesses::start(options, scenario, settings);
    if (!processes) return Unexpected{processes.error()};
    for (const std::string& command : processes->commands_elsewhere()) {
      fmt::print(stderr, "Start on the other host: {}\n", command);
    }
    settings.members = processes->members();
    settings.start_timeout += time_to_plan_again(planned_s);
    std::optional<OperatorDesk> desk;
    open_desk(desk, options, scenario);
    settings.observer = [&](const Envelope& envelope) {
      progress.observe(envelope);
      if (desk) desk->observe(envelope);
    };
    settings.says = [&] { return desk ? desk->says() : std::vector<Body>{}; };
    settings.interrupted = [&] { return is_interrupted() || processes->is_crippled(); };
    settings.dead_members = [&] { return processes->dead(); };

    auto result = transport::run_director(settings);
    if (!result) return Unexpected{processes->explanation(result.error().what)};
    return flight(std::move(*result), *processes);
  };
  return conduct(options, Mode::run, fly);
}

}  // namespace furrow::app
