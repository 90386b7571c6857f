#include "app/conduct.hpp"
#include "app/interrupt.hpp"
#include "mission/fleet.hpp"

namespace furrow::app {
namespace {

NodeHost whole_fleet(const mission::Scenario& scenario, const scheduler::FleetPlan& plan) {
  NodeHost host{scenario.link, scenario.seed};
  const auto add = [&](NodeId id, AnyNode node) {
    host.add(id, std::move(node), Instant{}, mission::death(scenario, id));
  };
  add(furrow::scheduler_node(), mission::scheduler_node(scenario, plan));
  for (const Station& station : scenario.stations) {
    add(node(station.id), mission::supply_node(scenario, station.id));
  }
  for (const Vehicle& uav : scenario.uavs) {
    const NodeId id = node(uav.id);
    add(id, mission::agent_node(scenario, plan.route.ferries, uav.id,
                                mission::first_boot(scenario, id)));
  }
  return host;
}

Expected<Flight, std::string> simulated(const mission::Scenario& scenario,
                                        const scheduler::FleetPlan& plan, Progress& progress) {
  NodeHost host = whole_fleet(scenario, plan);
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
