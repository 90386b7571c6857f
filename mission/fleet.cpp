#include "mission/fleet.hpp"

#include "agents/agent_node.hpp"
#include "core/random.hpp"
#include "core/raster.hpp"
#include "core/require.hpp"
#include "planner/avoidance/field_plan.hpp"
#include "scheduler/scheduler_node.hpp"
#include "supply/supply_node.hpp"

#include <algorithm>

namespace furrow::mission {
namespace {

constexpr Epoch first_epoch{1};

template <class T, class Id>
const T& with_id(const std::vector<T>& all, Id id) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const T& one) { return one.id == id; });
  require(found != all.end(), "a node is made only for a member of the scenario");
  return *found;
}

/// Detours of a radius that every aircraft flies and that no boom sweeps backwards in, with room
/// for the rounding of arcs to corners.
void fit_to_fleet(planner::AvoidanceSettings& avoidance, const Scenario& scenario) {
  constexpr double corner_room = 1.25;
  Length turn{}, half_swath{};
  for (const Vehicle& v : scenario.uavs) {
    turn = std::max(turn, v.min_turn_radius);
    half_swath = std::max(half_swath, 0.5 * v.swath);
  }
  avoidance.turn_radius = std::max(corner_room * turn, half_swath);
  avoidance.dubins_turns = turn > Length{};
  avoidance.seed = scenario.seed;
}

// How far an aircraft may be from where it takes itself to be: one fix in two million errs by more.
Length position_error(const std::vector<Vehicle>& uavs) {
  Length most{};
  for (const Vehicle& v : uavs) most = std::max(most, 5.0 * v.gnss.sigma + v.gnss.bias);
  return most;
}

// Rows under an RTK fix stray by 0.8 of its standard deviation; an overlap of nearly four such
// errors leaves less than a hundredth of the gaps of rows laid edge to edge. A bias shifts all rows
// of an aircraft alike. More than a tenth of the swath would cost more than it closes.
Length usual_overlap(const std::vector<Vehicle>& uavs) {
  Length most{};
  for (const Vehicle& v : uavs) most = std::max(most, std::min(3.0 * v.gnss.sigma, 0.1 * v.swath));
  return most;
}

// On land that ends a kilometre beyond the field.
Field without_boundary(Field field) {
  constexpr Length beyond = metres(1000);
  Extent all{field.boundary.front(), field.boundary.front()};
  for (const FieldPoint p : field.boundary) cover(all, p, beyond);
  const auto [low, high] = all;
  field.boundary = {low, {high.x, low.y}, high, {low.x, high.y}};
  return field;
}

// Volumes that no aircraft enters are kept away from as obstacles are.
planner::Room with_volumes(const planner::Room& room, const Scenario& scenario, Length clearance) {
  std::vector<planner::CircleM> circles;
  if (scenario.terrain) {
    for (const planner::KeepOut& volume : scenario.terrain->keep_out) {
      circles.push_back({{volume.x_m, volume.y_m}, volume.radius_m + clearance.base()});
    }
  }
  return room.with(std::move(circles));
}

// On board, every obstacle that the plan knows is one to keep the safety distance from, whether
// rows end at it or are led around it.
planner::AvoidanceRule avoidance_rule(const Scenario& scenario) {
  if (scenario.surprises.empty()) return {};
  const auto coverage = fleet_problem(scenario).coverage;
  const auto& avoidance = planner::avoidance_of(coverage);
  if (!avoidance) return {};
  const auto* swath = std::get_if<planner::SwathSettings>(&coverage);
  const Length clearance = avoidance->safety + metres(planner::tracking_room_m);
  const Length margin = std::visit([](const auto& settings) { return settings.margin; }, coverage);
  const Length buffer = swath ? swath->hole_buffer : Length{};
  auto room = planner::room_of(scenario.field, margin, buffer, clearance);
  auto beyond = planner::room_of(without_boundary(scenario.field), margin, buffer, clearance);
  require(room && beyond, "a field that was planned leaves room");
  return {.planned = with_volumes(*room, scenario, clearance),
          .beyond = with_volumes(*beyond, scenario, clearance),
          .clearance = clearance,
          .turn_radius = avoidance->turn_radius,
          .weights = {.length = avoidance->length_weight, .area = avoidance->area_weight}};
}

// Aircraft of a fleet fly between work and stations at heights of their own, no higher than 40 m or
// what keeps one of them clear of those at work.
std::optional<agents::AirspaceRule> airspace_rule(const Scenario& scenario, AgentId agent) {
  constexpr double room_m = 0.5, highest_m = 40.0;
  if (scenario.uavs.size() < 2) return std::nullopt;
  const double apart_m = std::min(scenario.separation.base() + room_m, highest_m);
  const auto most = static_cast<std::uint32_t>(highest_m / apart_m);
  const auto layers = std::min(most, static_cast<std::uint32_t>(scenario.uavs.size()));
  return agents::AirspaceRule{.layer = ((number(agent) - 1) % layers + 1.0) * metres(apart_m)};
}

std::optional<OperatorAsk> ask(Fault::Kind kind) {
  switch (kind) {
    case Fault::Kind::pause: return OperatorAsk::pause;
    case Fault::Kind::resume: return OperatorAsk::resume;
    case Fault::Kind::return_all: return OperatorAsk::return_all;
    case Fault::Kind::stop: return OperatorAsk::stop;
    case Fault::Kind::take_out: return OperatorAsk::take_out;
    default: return std::nullopt;
  }
}

std::vector<scheduler::TimedOrder> operator_orders(const Scenario& scenario) {
  std::vector<scheduler::TimedOrder> orders;
  for (const Fault& fault : scenario.faults) {
    if (const auto asked = ask(fault.kind)) {
      orders.push_back({fault.at, {.ask = *asked, .agent = AgentId{fault.target.number}}});
    }
  }
  return orders;
}

std::optional<planner::SurveySettings> survey_of(const Scenario& scenario) {
  constexpr std::uint64_t purpose = 0x737572766579;  // "survey"
  auto survey = scenario.survey;
  if (survey) survey->search.seed = seed_for(scenario.seed, {purpose});
  return survey;
}

}  // namespace

scheduler::FleetProblem fleet_problem(const Scenario& scenario) {
  planner::CoverageModel coverage = scenario.coverage;
  if (auto* grid = std::get_if<planner::CoverageSettings>(&coverage)) {
    grid->start = scenario.start;
    if (grid->avoidance) {
      fit_to_fleet(*grid->avoidance, scenario);
      grid->avoidance->dubins_turns = false;  // steps between strips are sprayed
    }
  }
  if (auto* swath = std::get_if<planner::SwathSettings>(&coverage)) {
    swath->near = scenario.start;
    if (swath->avoidance) fit_to_fleet(*swath->avoidance, scenario);
    swath->spray_margin = position_error(scenario.uavs);
    if (!swath->row_overlap) swath->row_overlap = usual_overlap(scenario.uavs);
  }
  std::vector<Vehicle> present, joining;
  for (const Vehicle& uav : scenario.uavs) {
    const Instant born = birth(scenario, node(uav.id));
    (born > Instant{} ? joining : present).push_back(uav);
    if (born == Instant{}) continue;
    Seconds& from = joining.back().available_from;
    from = std::max(from, seconds(born.time_since_epoch()));
  }
  return {.field = scenario.field,
          .coverage = coverage,
          .work_direction_deg = scenario.work_direction_deg,
          .stations = scenario.stations,
          .vehicles = std::move(present),
          .solver = scenario.solver,
          .terrain = scenario.terrain,
          .joining = std::move(joining),
          .survey = survey_of(scenario),
          .separation = scenario.separation};
}

BootId first_boot(const Scenario& scenario, NodeId node) {
  constexpr std::uint64_t purpose = 0x626f6f74;  // "boot"
  return BootId{
      seed_for(scenario.seed, {purpose, static_cast<std::uint64_t>(node.kind), node.number})};
}

Instant birth(const Scenario& scenario, NodeId node) {
  for (const Fault& fault : scenario.faults) {
    const bool joins = fault.kind == Fault::Kind::agent_join && fault.target == node;
    if (joins) return fault.at;
  }
  return Instant{};
}

Instant death(const Scenario& scenario, NodeId node) {
  Instant earliest = never;
  for (const Fault& fault : scenario.faults) {
    const bool kills = fault.kind == Fault::Kind::agent_kill && fault.target == node;
    if (kills) earliest = std::min(earliest, fault.at);
  }
  return earliest;
}

AnyNode scheduler_node(const Scenario& scenario, const scheduler::FleetPlan& plan) {
  return AnyNode{scheduler::SchedulerNode{{.plan = plan,
                                           .epoch = first_epoch,
                                           .agent_lease = scenario.agent_lease,
                                           .mission_limit = scenario.mission_limit,
                                           .orders = operator_orders(scenario),
                                           .separation = scenario.separation,
                                           .stations = scenario.stations,
                                           .avoidance = avoidance_rule(scenario)}}};
}

AnyNode supply_node(const Scenario& scenario, StationId station) {
  const Station& site = with_id(scenario.stations, station);
  std::vector<supply::Shutting> shuttings;
  for (const Fault& fault : scenario.faults) {
    if (fault.kind != Fault::Kind::bay_down || fault.target != node(station)) continue;
    for (std::uint32_t bay = 1; bay <= site.bays; ++bay) {
      if (fault.bay == 0 || fault.bay == bay) shuttings.push_back({fault.at, bay});
    }
  }
  std::map<AgentId, Volume> tanks;
  for (const Vehicle& uav : scenario.uavs) tanks[uav.id] = uav.tank;
  return AnyNode{supply::SupplyNode{{.station = site,
                                     .tanks = std::move(tanks),
                                     .terms = {.lease = scenario.agent_lease},
                                     .shuttings = std::move(shuttings)}}};
}

AnyNode agent_node(const Scenario& scenario, const planner::FerryMap& ferries, AgentId agent,
                   BootId boot) {
  return AnyNode{agents::AgentNode{{.vehicle = with_id(scenario.uavs, agent),
                                    .stations = scenario.stations,
                                    .wind = scenario.wind,
                                    .ferries = ferries,
                                    .avoidance = avoidance_rule(scenario),
                                    .surprises = scenario.surprises,
                                    .airspace = airspace_rule(scenario, agent),
                                    .seed = scenario.seed,
                                    .boot = boot}}};
}

NodeHost whole_fleet(const Scenario& scenario, const scheduler::FleetPlan& plan) {
  NodeHost host{scenario.link, scenario.seed};
  const auto add = [&](NodeId id, AnyNode node) {
    host.add(id, std::move(node), birth(scenario, id), death(scenario, id));
  };
  add(furrow::scheduler_node(), scheduler_node(scenario, plan));
  for (const Station& station : scenario.stations) {
    add(node(station.id), supply_node(scenario, station.id));
  }
  for (const Vehicle& uav : scenario.uavs) {
    const NodeId id = node(uav.id);
    add(id, agent_node(scenario, plan.route.ferries, uav.id, first_boot(scenario, id)));
  }
  return host;
}

}  // namespace furrow::mission
