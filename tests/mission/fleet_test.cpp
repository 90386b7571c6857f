#include "mission/fleet.hpp"

#include "mission/load.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace furrow::mission {
namespace {

// Agent 2 asks for the bay that agent 1 asked for at the epoch, and was not heard of since.
bool is_served_at(Scenario scenario, Duration lease, Instant at) {
  scenario.agent_lease = lease;
  AnyNode station = supply_node(scenario, StationId{1});
  const auto claim = [](std::uint32_t agent, Instant when) {
    return Envelope{.from = node(AgentId{agent}),
                    .seq = 1,
                    .sent = when,
                    .body = ServiceClaim{.agent = AgentId{agent},
                                         .boot = BootId{agent},
                                         .station = StationId{1},
                                         .claim = 1,
                                         .first_claimed = when,
                                         .status = ClaimStatus::waiting,
                                         .token = 0,
                                         .swap = true,
                                         .fill = 1.0}};
  };
  station.step({}, Instant{});
  station.step({claim(1, Instant{})}, Instant{});
  const Outbox out = station.step({claim(2, at)}, at);
  return std::any_of(out.messages.begin(), out.messages.end(), [](const Body& body) {
    const auto* grant = std::get_if<ServiceGrant>(&body);
    return grant != nullptr && grant->agent == AgentId{2};
  });
}

TEST_CASE("fleet: a station holds a silent agent's bay for the scenario's lease", "[mission]") {
  const auto scenario = load("scenarios/wang2017_field_a.yaml");
  REQUIRE(scenario);
  const Instant at{std::chrono::seconds{6}};
  CHECK(is_served_at(*scenario, std::chrono::seconds{3}, at));  // 3 s, and 1 s to clear the bay
  CHECK_FALSE(is_served_at(*scenario, std::chrono::seconds{10}, at));
}

TEST_CASE("fleet: rows overlap as the fixes of the fleet ask, unless the scenario says how much",
          "[mission]") {
  auto scenario = load("scenarios/garden.yaml");
  REQUIRE(scenario);
  const auto overlap = [&] {
    const scheduler::FleetProblem plan = fleet_problem(*scenario);
    return *std::get<planner::SwathSettings>(plan.coverage).row_overlap;
  };
  scenario->uavs[0].gnss.sigma = metres(0.02);
  CHECK(overlap().base() == Approx(0.06));
  scenario->uavs[0].gnss.sigma = metres(1.5);
  CHECK(overlap() == 0.1 * scenario->uavs[0].swath);
  std::get<planner::SwathSettings>(scenario->coverage).row_overlap = metres(0);
  CHECK(overlap() == metres(0));
}

}  // namespace
}  // namespace furrow::mission
