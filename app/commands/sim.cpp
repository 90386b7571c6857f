#include "app/conduct.hpp"
#include "app/interrupt.hpp"
#include "mission/fleet.hpp"

namespace furrow::app {
namespace {

Expected<Flight, std::string> simulated(const mission::Scenario& scenario,
                                        const scheduler::FleetPlan& plan, double,
                                        Progress& progress) {
  NodeHost host = mission::whole_fleet(scenario, plan);
  const auto watch = [&](const std::vector<Envelope>& sent) {
    for (const Envelope& envelope : sent) progress.observe(envelope);
    return !is_interrupted();
  };
  Flight flight{};
  flight.log = sim::simulate(host, scenario.link.latency, Instant{scenario.mission_limit}, watch);
  flight.broken_off = is_interrupted();
  return flight;
}

}  // namespace

int sim(const Options& options) {
  catch_interrupts();
  return conduct(options, Mode::sim, simulated);
}

}  // namespace furrow::app
