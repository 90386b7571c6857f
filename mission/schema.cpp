#include "mission/schema.hpp"

#include "mission/obstacles.hpp"
#include "mission/outline.hpp"
#include "mission/survey.hpp"
#include "mission/terrain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace furrow::mission {
namespace {

constexpr std::size_t most_uavs = 1'000, most_entries = 1'000;
constexpr std::uint64_t most_id = 1'000'000;

// Keys that concern one coverage model only.
constexpr std::array grid_keys{"straight_reward", "turn_reward", "min_region_cells"};
constexpr std::array swath_keys{"hole_buffer_m",    "edges",         "last_row",
                                "cells_may_differ", "min_strip_m",   "row_overlap_m",
                                "headland_passes",  "headland_turn", "turn_cost_m"};

planner::CoverageSettings read_grid(const Section& s, Length margin) {
  planner::CoverageSettings grid;
  grid.margin = margin;
  grid.straight_reward = s.number("straight_reward", above_to(1, 1e6), 2);
  grid.turn_reward = s.number("turn_reward", above_to(1, 1e6), 3);
  grid.min_region_cells = static_cast<std::uint32_t>(s.whole("min_region_cells", 1, 1'000'000, 10));
  if (grid.turn_reward <= grid.straight_reward) {
    const auto rule = fmt::format("must exceed straight_reward, {:.10g}", grid.straight_reward);
    s.fail(s.has("turn_reward") ? "turn_reward" : "straight_reward",
           s.has("turn_reward")
               ? rule
               : fmt::format("must be less than turn_reward, {:.10g}", grid.turn_reward));
  }
  return grid;
}

// Its turn radius is that of the fleet.
std::optional<planner::AvoidanceSettings> read_avoidance(const Section& s, Length safety) {
  planner::AvoidanceSettings made;
  const std::size_t method =
      s.choice("method", {"none", "genetic", "exact", "split", "classic"}, 0);
  made.safety = safety;
  made.length_weight = s.number("length_weight", from_to(0, 1), 0.5);
  made.area_weight = s.number("area_weight", from_to(0, 1), 0.5);
  made.iterations = static_cast<std::uint32_t>(s.whole("iterations", 0, 100'000, 200));
  made.population = static_cast<std::uint32_t>(s.whole("population", 2, 10'000, 60));
  using planner::AvoidanceMethod;
  constexpr std::array methods{AvoidanceMethod::genetic, AvoidanceMethod::exact,
                               AvoidanceMethod::split, AvoidanceMethod::classic};
  if (method == 0) return std::nullopt;
  made.method = methods[method - 1];
  return made;
}

planner::SwathSettings read_swath(const Section& s, Length margin) {
  using namespace planner;
  SwathSettings swath;
  swath.margin = margin;
  swath.hole_buffer = metres(s.number("hole_buffer_m", from_to(0, 1000), 0));
  swath.edges = static_cast<EdgeMode>(s.choice("edges", {"cover_all", "stay_inside"}, 0));
  swath.last_row = static_cast<LastRow>(s.choice("last_row", {"shifted", "narrowed"}, 0));
  swath.cells_may_differ = s.flag("cells_may_differ", true);
  swath.min_strip = metres(s.number("min_strip_m", from_to(0, 10'000), 0));
  const auto overlap = s.optional_number("row_overlap_m", from_to(0, 50),
                                         "3 gnss.sigma_m, a tenth of the swath at most");
  if (overlap) swath.row_overlap = metres(*overlap);
  swath.headland_passes = static_cast<int>(s.whole("headland_passes", 0, 100, 0));
  swath.headland_turn =
      static_cast<HeadlandTurn>(s.choice("headland_turn", {"clockwise", "counter_clockwise"}, 1));
  swath.turn_cost = metres(s.number("turn_cost_m", from_to(0, 1000), 5));
  return swath;
}

planner::CoverageModel read_coverage(const Section& s) {
  const bool is_grid = s.choice("model", {"grid", "swath"}, 1) == 0;
  const Length margin = metres(s.number("margin_m", from_to(0, 1000), 0));
  auto grid = read_grid(s, margin);
  auto swath = read_swath(s, margin);
  const Section around = s.section("avoidance");
  grid.safety = swath.safety = metres(around.number("safety_m", from_to(0, 100), 1));
  grid.avoidance = swath.avoidance = read_avoidance(around, grid.safety);
  const auto refuse = [&](const auto& keys, const char* model) {
    for (const char* key : keys) {
      if (s.has(key)) s.fail(key, fmt::format("belongs to the coverage model {}", model));
    }
  };
  if (is_grid) {
    refuse(swath_keys, "swath");
    return grid;
  }
  refuse(grid_keys, "grid");
  return swath;
}

// The heading of the strips: a number, or the way from A to B.
std::optional<double> read_direction(const Section& s) {
  const auto heading = s.optional_number("work_direction_deg", from_below(0, 360), "searched");
  const Section line = s.section("ab_line");
  const auto a = line.optional_point("a_m", "work_direction_deg");
  const auto b = line.optional_point("b_m", "work_direction_deg");
  if (!a && !b) return heading;
  if (s.has("work_direction_deg")) s.fail("ab_line", "must be left out beside work_direction_deg");
  if (!a || !b || *a == *b) {
    s.fail("ab_line", "must have a_m and b_m, two places apart");
    return heading;
  }
  const double along_deg =
      std::atan2((b->x - a->x).base(), (b->y - a->y).base()) * 180 / std::numbers::pi;
  return along_deg < 0 ? along_deg + 360 : along_deg;
}

void read_field(const Section& s, Scenario& out) {
  read_outline(s, out);
  out.work_direction_deg = read_direction(s);
  out.start = s.optional_point("start_m", "chosen");
  out.coverage = read_coverage(s.section("coverage"));
  const bool is_grid = std::holds_alternative<planner::CoverageSettings>(out.coverage);
  const double quarter_turns = out.work_direction_deg.value_or(0) / 90;
  if (is_grid && quarter_turns != std::floor(quarter_turns)) {
    s.fail(s.has("ab_line") ? "ab_line" : "work_direction_deg",
           "must be one of 0, 90, 180, 270: a grid is flown along its sides");
  }
}

// Of a UAV or a station.
template <class T>
void read_window(const Section& s, T& of) {
  constexpr double longest_s = 10'000'000;
  of.available_from = seconds(s.number("available_from_s", from_to(0, longest_s), 0));
  const auto until = s.optional_number("available_until_s", above_to(0, longest_s), "no end");
  if (!until) return;
  of.available_until = seconds(*until);
  if (of.available_from < *of.available_until) return;
  s.fail("available_until_s",
         fmt::format("must be later than available_from_s, {:.10g}", of.available_from.base()));
}

Station read_station(const Section& s) {
  const Section fill = s.required_section("fill");
  const auto mix_l = s.optional_number("mix_l", from_to(0, 1e9), "no end of it");
  const auto packs = s.optional_whole("packs", 0, 1'000'000, "no end of them");
  Station station{.id = static_cast<StationId>(s.whole("id", 1, most_id)),
                  .position = s.point("position_m"),
                  .bays = static_cast<std::uint32_t>(s.whole("bays", 1, 100, 1)),
                  .battery_swap = seconds(s.number("battery_swap_s", from_to(0, 86'400))),
                  .fill_base = seconds(fill.number("base_s", from_to(0, 86'400))),
                  .fill_full = seconds(fill.number("full_s", from_to(0, 86'400)))};
  if (mix_l) station.mix = litres(*mix_l);
  if (packs) station.packs = static_cast<std::uint32_t>(*packs);
  read_window(s, station);
  if (fill.has("base_s") && station.fill_base > station.fill_full) {
    fill.fail("base_s", fmt::format("must not exceed full_s, {:.10g}", station.fill_full.base()));
  }
  return station;
}

void read_supply(const Section& root, Draft& draft) {
  std::vector<std::pair<Station, Section>> found;
  std::set<StationId> ids;
  for (const auto& s : root.list("supply", 1, 100)) {
    found.emplace_back(read_station(s), s);
    if (s.has("id") && !ids.insert(found.back().first.id).second) {
      s.fail("id", "must be unique among the stations");
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first.id < b.first.id; });
  for (const auto& [station, section] : found) {
    draft.scenario.stations.push_back(station);
    draft.stations.push_back(section);
  }
}

// A tank lasts for the time given, or for what its rate makes of it over the swath.
Seconds read_spray_endurance(const Section& s, const Vehicle& v, bool has_tank) {
  const auto given = s.optional_number("spray_endurance_s", from_to(1, 86'400),
                                       "tank_l / (rate_l_ha swath_m spray_speed_mps)");
  const auto rate =
      s.optional_number("rate_l_ha", from_to(0.1, 10'000), "from tank_l and spray_endurance_s");
  if (s.has("spray_endurance_s") && s.has("rate_l_ha")) {
    s.fail("rate_l_ha", "must be left out where spray_endurance_s is given");
  }
  if (given || s.has("spray_endurance_s")) return seconds(given.value_or(1));
  if (!s.has("rate_l_ha") || !has_tank) {
    s.fail("spray_endurance_s", "is required, or tank_l with rate_l_ha");
    return seconds(1);
  }
  const Seconds lasts = v.tank / (litres_per_hectare(rate.value_or(1)) * v.swath * v.spray_speed);
  if (rate && (lasts < seconds(1) || lasts > seconds(86'400))) {
    s.fail("rate_l_ha", "must let tank_l last from 1 to 86400 s of spraying",
           fmt::format("{:.6g} s", lasts.base()));
  }
  return lasts;
}

Gnss read_gnss(const Section& s) {
  return {.sigma = metres(s.number("sigma_m", from_to(0, 100), 0.02)),
          .bias = metres(s.number("bias_m", from_to(0, 100), 0))};
}

// The id is set by the caller.
Vehicle read_vehicle(const Section& s) {
  Vehicle v{
      .id = {},
      .home = {},
      .swath = metres(s.number("swath_m", from_to(0.1, 100))),
      .spray_speed = metres_per_second(s.number("spray_speed_mps", from_to(0.1, 100))),
      .ferry_speed = metres_per_second(s.number("ferry_speed_mps", from_to(0.1, 100))),
      .spray_endurance = {},
      .flight_endurance = seconds(s.number("flight_endurance_s", from_to(1, 86'400))),
      .battery_reserve = s.number("battery_reserve", from_below(0, 1), 0.1),
      .tank = litres(s.number("tank_l", from_to(0.01, 100'000), 10)),
      .min_turn_radius = metres(s.number("min_turn_radius_m", from_to(0, 1000), 0)),
      .acceleration_limit = metres_per_second2(s.number("acceleration_mps2", from_to(0.1, 100), 3)),
      .gnss = read_gnss(s.section("gnss"))};
  v.spray_endurance = read_spray_endurance(s, v, s.has("tank_l"));
  read_window(s, v);
  return v;
}

void read_uavs(const Section& root, Draft& draft) {
  std::uint64_t total = 0;
  draft.fleets = root.list("uavs", 1, most_entries);
  for (std::size_t i = 0; i < draft.fleets.size(); ++i) {
    const Section& s = draft.fleets[i];
    const auto count = s.whole("count", 1, most_uavs, 1);
    const auto start = s.optional_point("start_m", "the nearest station's position");
    Vehicle v = read_vehicle(s);
    v.home = start.value_or(FieldPoint{});
    draft.has_start.push_back(start.has_value());
    for (total += count; draft.scenario.uavs.size() < std::min(total, most_uavs);) {
      v.id = static_cast<AgentId>(draft.scenario.uavs.size() + 1);
      draft.scenario.uavs.push_back(v);
      draft.fleet_of.push_back(i);
    }
  }
  if (total > most_uavs) {
    root.fail("uavs", fmt::format("must be at most {} UAVs in all", most_uavs),
              fmt::format("{}", total));
  }
}

Wind read_wind(const Section& s) {
  return {.mean = metres_per_second(s.number("mean_mps", from_to(0, 50), 0)),
          .from_deg = s.number("from_deg", from_below(0, 360), 0),
          .gust = metres_per_second(s.number("gust_mps", from_to(0, 50), 0))};
}

planner::SolveSettings read_solver(const Section& s, std::uint64_t seed) {
  using enum planner::ReturnStrategy;
  const auto choice =
      s.choice("returns", {name(unplanned), name(simple), name(gsa), name(exact), name(joint)},
               std::size_t{4});
  const planner::SolveSettings settings{
      .returns = static_cast<planner::ReturnStrategy>(choice),
      .refine = s.flag("refine", true),
      .paper_counting = s.flag("paper_counting", false),
      .iterations = static_cast<std::uint32_t>(s.whole("iterations", 1, 1'000'000, 300)),
      .masses = static_cast<std::uint32_t>(s.whole("agents", 2, 100'000, 50)),
      .budget_s = s.number("budget_s", above_to(0, 3600), 10),
      .seed = seed};
  if (settings.paper_counting && settings.returns != unplanned) {
    s.fail("paper_counting", "must be false unless returns is unplanned");
  }
  return settings;
}

Link read_link(const Section& s) {
  return {.latency = duration(seconds(s.number("latency_s", from_to(0.001, 10), 0.05))),
          .jitter = duration(seconds(s.number("jitter_s", from_to(0, 10), 0))),
          .loss = s.number("loss", from_below(0, 1), 0),
          .duplication = s.number("duplicate", from_below(0, 1), 0)};
}

// Orders to the whole fleet have none.
NodeId read_target(const Section& s, Fault::Kind kind) {
  if (kind >= Fault::Kind::pause && kind <= Fault::Kind::stop) {
    s.refuse("target", "must be left out of orders to the whole fleet");
    return scheduler_node();
  }
  const bool is_of_station = kind == Fault::Kind::bay_down;
  const auto target = s.whole("target", 1, is_of_station ? most_id : most_uavs);
  return is_of_station ? node(static_cast<StationId>(target)) : node(static_cast<AgentId>(target));
}

void read_faults(const Section& root, Draft& draft) {
  std::vector<std::pair<Fault, Section>> found;
  for (const auto& s : root.list("faults", 0, most_entries)) {
    const auto at = s.number("at_s", from_to(0, 10'000'000));
    const auto kind =
        static_cast<Fault::Kind>(s.choice("kind", {fault_names.begin(), fault_names.end()}));
    Fault fault{.at = instant(seconds(at)), .kind = kind, .target = read_target(s, kind)};
    const auto bay = s.optional_whole("bay", 1, 100, "all");
    fault.bay = static_cast<std::uint32_t>(bay.value_or(0));
    if (bay && kind != Fault::Kind::bay_down) {
      s.fail("bay", "must be left out where the kind is not bay_down");
    }
    found.emplace_back(fault, s);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first.at < b.first.at; });
  for (const auto& [fault, section] : found) {
    draft.scenario.faults.push_back(fault);
    draft.faults.push_back(section);
  }
}

std::vector<Expectation> read_expectations(const Section& s) {
  std::vector<Expectation> expectations;
  if (const auto completed = s.optional_flag("completed", "not expected")) {
    const double value = *completed ? 1 : 0;
    expectations.push_back({"completed", value, value});
  }
  for (const char* key :
       {"missed_m2", "covered_m2", "repeated_m2", "outside_m2", "makespan_s", "gap", "non_spray_s",
        "queue_wait_s", "route_m", "ferry_m", "flown_outside_m", "outside_at_work_m",
        "cross_track_rms_m", "encounters", "clearance_share"}) {
    const Section figure = s.section(key);
    const Expectation e{.key = key,
                        .min = figure.optional_number("min", from_to(0, 1e12), "no limit"),
                        .max = figure.optional_number("max", from_to(0, 1e12), "no limit")};
    if (e.min && e.max && *e.min > *e.max) {
      figure.fail("min", fmt::format("must not exceed max, {:.10g}", *e.max));
    }
    if (e.min || e.max) expectations.push_back(e);
  }
  return expectations;
}

void read_limits(const Section& s, Scenario& out) {
  out.agent_lease = duration(seconds(s.number("agent_lease_s", above_to(1, 3600), 3)));
  out.mission_limit = duration(seconds(s.number("mission_s", from_to(1, 10'000'000), 86'400)));
  constexpr double usual_m = 1.0;
  double narrowest_m = usual_m / widest_separation;
  for (const Vehicle& v : out.uavs) narrowest_m = std::min(narrowest_m, v.swath.base());
  out.separation =
      metres(s.number("separation_m", above_to(0, 1000), widest_separation * narrowest_m));
}

// Whether reading a part finds nothing wrong with it.
template <class Read>
bool in_order(const Section& root, Read read) {
  const auto before = root.findings().count();
  read();
  return root.findings().count() == before;
}

}  // namespace

Draft read_scenario(const Section& root) {
  Draft draft{};
  Scenario& s = draft.scenario;
  root.whole("version", 1, 1);
  s.name = root.name("name");
  s.seed = root.whole("seed", 0, UINT64_MAX, 1);
  draft.field_in_order = in_order(root, [&] { read_field(root.required_section("field"), s); });
  read_obstacles(root, draft);
  draft.supply_in_order = in_order(root, [&] { read_supply(root, draft); });
  draft.fleet_in_order = in_order(root, [&] { read_uavs(root, draft); });
  s.wind = read_wind(root.section("wind"));
  s.terrain = read_terrain(root.section("terrain"), s);
  s.survey = read_survey(root, s);
  s.solver = read_solver(root.section("solver"), s.seed);
  s.link = read_link(root.section("link"));
  read_limits(root.section("limits"), s);
  draft.faults_in_order = in_order(root, [&] { read_faults(root, draft); });
  s.expectations = read_expectations(root.section("expect"));
  return draft;
}

}  // namespace furrow::mission
