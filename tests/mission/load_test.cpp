#include "mission/load.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

namespace furrow::mission {
namespace {

const std::string part_field =
    "version: 1\nname: a\nfield:\n  boundary_m: [[0,0],[90,0],[90,60]]\n";
const std::string part_supply =
    "supply:\n  - {id: 4, position_m: [0,-5], battery_swap_s: 60, fill: {base_s: 20, full_s: "
    "60}}\n";
const std::string part_uavs =
    "uavs:\n  - swath_m: 2\n    spray_speed_mps: 3\n    ferry_speed_mps: 6\n"
    "    flight_endurance_s: 1500\n";
const std::string least = part_field + part_supply + part_uavs + "    spray_endurance_s: 900\n";

Scenario scenario(const std::string& yaml) {
  const auto result = parse(yaml, "test.yaml");
  if (!result) FAIL(text(result.error().front()));
  return *result;
}

std::vector<std::string> messages(const std::string& yaml) {
  const auto result = parse(yaml, "test.yaml");
  std::vector<std::string> lines;
  if (!result) {
    for (const auto& e : result.error()) lines.push_back(text(e));
  }
  return lines;
}

TEST_CASE("load: what a scenario leaves out has its default", "[mission]") {
  const Scenario s = scenario(least);

  CHECK(s.seed == 1);
  CHECK(s.field.boundary.size() == 3);
  CHECK(s.field.holes.empty());
  CHECK(s.field.obstacles.empty());
  CHECK_FALSE(s.work_direction_deg);
  CHECK_FALSE(s.start);
  CHECK_FALSE(s.datum);
  const auto& swath = std::get<planner::SwathSettings>(s.coverage);
  CHECK(swath.margin == metres(0));
  CHECK(swath.hole_buffer == metres(0));
  CHECK(swath.edges == planner::EdgeMode::cover_all);
  CHECK(swath.last_row == planner::LastRow::shifted);
  CHECK(swath.cells_may_differ);
  CHECK(swath.min_strip == metres(0));
  CHECK_FALSE(swath.row_overlap);
  CHECK(swath.headland_passes == 0);
  CHECK(swath.turn_cost == metres(5));
  REQUIRE(s.stations.size() == 1);
  CHECK(s.stations[0].bays == 1);
  REQUIRE(s.uavs.size() == 1);
  const Vehicle& v = s.uavs[0];
  CHECK(number(v.id) == 1);
  CHECK(v.home == at_m(0, -5));
  CHECK(v.battery_reserve == 0.1);
  CHECK(v.tank == litres(10));
  CHECK(v.min_turn_radius == metres(0));
  CHECK(v.acceleration_limit == metres_per_second2(3));
  CHECK(v.gnss.sigma == metres(0.02));
  CHECK(v.gnss.bias == metres(0));
  CHECK(s.wind.mean == metres_per_second(0));
  CHECK(s.solver.returns == planner::ReturnStrategy::joint);
  CHECK(s.solver.refine);
  CHECK_FALSE(s.solver.paper_counting);
  CHECK(s.solver.iterations == 300);
  CHECK(s.solver.masses == 50);
  CHECK(s.solver.budget_s == 10);
  CHECK(s.solver.seed == 1);
  CHECK(s.link.latency == Duration{50'000'000});
  CHECK(s.link.jitter == Duration{0});
  CHECK(s.agent_lease == Duration{3'000'000'000});
  CHECK(s.mission_limit == Duration{86'400'000'000'000});
  CHECK(s.faults.empty());
  CHECK(s.expectations.empty());
}

TEST_CASE("load: land, supply and fleet are read as they are written", "[mission]") {
  const Scenario s = scenario(
      "version: 1\nname: full.1\nseed: 18446744073709551615\n"
      "field:\n  boundary_m: [[0,0],[100,0],[100,50],[0,50],[0,0]]\n"
      "  holes_m: [[[10,10],[20,10],[20,20]],[[60,10],[70,10],[70,20]]]\n"
      "  work_direction_deg: 270\n  start_m: [1.5, 2]\n"
      "  coverage: {model: grid, margin_m: 1, straight_reward: 4, turn_reward: 5,"
      " min_region_cells: 3}\n"
      "obstacles:\n  - {id: tree-1, center_m: [30, 40], radius_m: 2.5}\n"
      "supply:\n"
      "  - {id: 7, position_m: [100, 0], bays: 3, battery_swap_s: 50, fill: {base_s: 10, full_s: "
      "40}}\n"
      "  - {id: 2, position_m: [0, 0], battery_swap_s: 60, fill: {base_s: 20, full_s: 60}}\n"
      "uavs:\n"
      "  - {count: 2, start_m: [3, 4], swath_m: 2, spray_speed_mps: 3, ferry_speed_mps: 6,\n"
      "     spray_endurance_s: 900, tank_l: 16, flight_endurance_s: 1500, battery_reserve: 0.2,\n"
      "     min_turn_radius_m: 1, acceleration_mps2: 2, gnss: {sigma_m: 1.5, bias_m: 0.5}}\n"
      "  - {swath_m: 2, spray_speed_mps: 4, ferry_speed_mps: 6, tank_l: 12, rate_l_ha: 15,\n"
      "     flight_endurance_s: 1500}\n");

  CHECK(s.name == "full.1");
  CHECK(s.seed == UINT64_MAX);
  CHECK(s.solver.seed == UINT64_MAX);
  CHECK(s.field.boundary == Ring{at_m(0, 0), at_m(100, 0), at_m(100, 50), at_m(0, 50)});
  REQUIRE(s.field.holes.size() == 2);
  CHECK(s.field.holes[1] == Ring{at_m(60, 10), at_m(70, 10), at_m(70, 20)});
  CHECK(s.work_direction_deg == 270);
  CHECK(s.start == at_m(1.5, 2));
  const auto& grid = std::get<planner::CoverageSettings>(s.coverage);
  CHECK(grid.margin == metres(1));
  CHECK(grid.straight_reward == 4);
  CHECK(grid.turn_reward == 5);
  CHECK(grid.min_region_cells == 3);
  REQUIRE(s.field.obstacles.size() == 1);
  CHECK(s.field.obstacles[0].id == "tree-1");
  CHECK(s.field.obstacles[0].center == at_m(30, 40));
  CHECK(s.field.obstacles[0].radius == metres(2.5));
  REQUIRE(s.stations.size() == 2);  // In order of id.
  CHECK(number(s.stations[0].id) == 2);
  CHECK(number(s.stations[1].id) == 7);
  CHECK(s.stations[1].position == at_m(100, 0));
  CHECK(s.stations[1].bays == 3);
  CHECK(s.stations[1].battery_swap == seconds(50));
  CHECK(s.stations[1].fill_base == seconds(10));
  CHECK(s.stations[1].fill_full == seconds(40));
  REQUIRE(s.uavs.size() == 3);
  for (std::uint32_t i = 0; i < 3; ++i) CHECK(number(s.uavs[i].id) == i + 1);
  CHECK(s.uavs[1].home == at_m(3, 4));
  CHECK(s.uavs[1].spray_endurance == seconds(900));
  CHECK(s.uavs[1].flight_endurance == seconds(1500));
  CHECK(s.uavs[1].tank == litres(16));
  CHECK(s.uavs[1].battery_reserve == 0.2);
  CHECK(s.uavs[1].min_turn_radius == metres(1));
  CHECK(s.uavs[1].acceleration_limit == metres_per_second2(2));
  CHECK(s.uavs[1].gnss.sigma == metres(1.5));
  CHECK(s.uavs[1].gnss.bias == metres(0.5));
  CHECK(s.uavs[2].home == at_m(0, 0));  // The station nearest to the start.
  // 12 l at 15 l/ha cover 0.8 ha; over a 2 m swath 4000 m; at 4 m/s 1000 s.
  CHECK(s.uavs[2].spray_endurance.base() == Approx(1000));
  CHECK(application_rate(s.uavs[2]) / litres_per_hectare(1) == Approx(15));
}

TEST_CASE("load: weather, solver, radio, limits, faults and expectations are read", "[mission]") {
  const Scenario s = scenario(
      least +
      "  - {swath_m: 2, spray_speed_mps: 3, ferry_speed_mps: 6, spray_endurance_s: 900,"
      " flight_endurance_s: 1500}\n"
      "wind: {mean_mps: 6, from_deg: 90, gust_mps: 1.5}\n"
      "solver: {returns: unplanned, refine: false, paper_counting: true, iterations: 7, agents: 8,"
      " budget_s: 0.5}\n"
      "link: {latency_s: 0.1, jitter_s: 0.2, loss: 0.3, duplicate: 0.4}\n"
      "limits: {agent_lease_s: 5, mission_s: 7200}\n"
      "faults:\n  - {at_s: 20.5, kind: agent_kill, target: 2}\n"
      "  - {at_s: 0, kind: agent_kill, target: 1}\n"
      "expect: {completed: false, missed_m2: {max: 200}, gap: {min: 0, max: 0.1}}\n");

  CHECK(s.wind.mean == metres_per_second(6));
  CHECK(s.wind.from_deg == 90);
  CHECK(s.wind.gust == metres_per_second(1.5));
  CHECK(s.solver.returns == planner::ReturnStrategy::unplanned);
  CHECK_FALSE(s.solver.refine);
  CHECK(s.solver.paper_counting);
  CHECK(s.solver.iterations == 7);
  CHECK(s.solver.masses == 8);
  CHECK(s.solver.budget_s == 0.5);
  CHECK(s.link.latency == Duration{100'000'000});
  CHECK(s.link.jitter == Duration{200'000'000});
  CHECK(s.link.loss == 0.3);
  CHECK(s.link.duplication == 0.4);
  CHECK(s.agent_lease == Duration{5'000'000'000});
  CHECK(s.mission_limit == Duration{7'200'000'000'000});
  REQUIRE(s.faults.size() == 2);  // In order of time.
  CHECK(s.faults[0].target == node(AgentId{1}));
  CHECK(s.faults[1].target == node(AgentId{2}));
  CHECK(s.faults[1].at == Instant{Duration{20'500'000'000}});
  REQUIRE(s.expectations.size() == 3);
  CHECK(s.expectations[0].key == "completed");
  CHECK(s.expectations[0].min == 0);
  CHECK(s.expectations[0].max == 0);
  CHECK(s.expectations[1].key == "missed_m2");
  CHECK_FALSE(s.expectations[1].min);
  CHECK(s.expectations[1].max == 200);
  CHECK(s.expectations[2].min == 0);
  CHECK(s.expectations[2].max == 0.1);
}

TEST_CASE("load: each way to choose return points has its name", "[mission]") {
  using enum planner::ReturnStrategy;
  for (const auto strategy : {unplanned, simple, gsa, exact, joint}) {
    const Scenario s = scenario(least + "solver: {returns: " + planner::name(strategy) + "}\n");
    CHECK(s.solver.returns == strategy);
  }
}

TEST_CASE("load: an error of the radio hides none of the fleet", "[mission]") {
  const auto lines =
      messages(least + "faults: [{at_s: 1, kind: agent_kill, target: 2}]\nlinks: {}\n");

  REQUIRE(lines.size() == 2);
  CHECK(lines[0] == "test.yaml:13: faults[0].target: must be the id of a UAV, 1 to 1 (got 2)");
  CHECK(lines[1] == "test.yaml:14: links: must be a known key, the nearest is link (got a map)");
}

TEST_CASE("load: a file that is not there, is a folder or is too large is an error", "[mission]") {
  const auto message = [](const std::string& path) {
    const auto result = load(path);
    return result ? std::string{"loaded"} : text(result.error().at(0));
  };
  CHECK(message("scenarios/none.yaml") ==
        "scenarios/none.yaml:0: file: must exist (got no such file)");
  CHECK(message("scenarios") == "scenarios:0: file: must be a file (got something else)");

  const auto large = std::filesystem::temp_directory_path() / "furrow_large_scenario.yaml";
  std::ofstream{large} << std::string(1'048'577, '#');
  CHECK(message(large.string()) ==
        large.string() + ":0: file: must hold at most 1 MiB (got 1048577 bytes)");
  std::filesystem::remove(large);
}

TEST_CASE("load: hostile text is refused without harm", "[mission]") {
  const auto repeated = [](std::string_view part, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += part;
    return all;
  };
  for (const char* part : {"[", "{a: ", "- ", "? ", "a: ", "&a ", "[a,", "\"", "|\n", "!!x ", "*a ",
                           "%", "\xff\xfe", "\n\t", "a\n", "- - a\n", "---\n", "'"}) {
    CHECK_FALSE(messages(repeated(part, 20'000)).empty());
  }
  CHECK_FALSE(messages(std::string(1000, '\0')).empty());
}

}  // namespace
}  // namespace furrow::mission
