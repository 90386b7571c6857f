#include "bytes.hpp"
#include "transport/contract.hpp"

#include <catch2/catch.hpp>

#include <limits>

namespace furrow {
namespace {

using transport::decoded;
using transport::encoded;

Envelope from(NodeId node, Body body) {
  return {
      .from = node, .seq = 42, .sent = Instant{Duration{1'234'567'890}}, .body = std::move(body)};
}

Vehicle vehicle() {
  return {.id = AgentId{7},
          .home = at_m(1, -2),
          .swath = metres(2),
          .spray_speed = metres_per_second(3),
          .ferry_speed = metres_per_second(6),
          .spray_endurance = seconds(900),
          .flight_endurance = seconds(1500),
          .battery_reserve = 0.1,
          .tank = litres(10),
          .min_turn_radius = metres(4),
          .acceleration_limit = metres_per_second2(3.5),
          .gnss = {.sigma = metres(0.02), .bias = metres(0.01)},
          .available_from = seconds(600),
          .available_until = seconds(700)};
}

SortieReport sortie_report() {
  return {.agent = AgentId{7},
          .sortie = 3,
          .resumed_at = at_m(1, 2),
          .returned_at = at_m(3, 4),
          .sprayed = metres(100),
          .ferried = metres(20),
          .flight = seconds(60),
          .pack = 2,
          .battery_used = 0.25,
          .began = Instant{Duration{1}},
          .spray_ended = Instant{Duration{2}},
          .landed = Instant{Duration{3}},
          .serviced = true,
          .station = StationId{2},
          .bay = 1,
          .swapped = true,
          .filled = 0.9,
          .wait = seconds(5),
          .swap_time = seconds(6),
          .fill_time = seconds(7)};
}

// One of each kind, every field different from its neighbours.
std::vector<Envelope> samples() {
  const NodeId agent = node(AgentId{7}), station = node(StationId{2});
  const Piece piece{.cells = {10, 5},
                    .entry = at_m(1, 2),
                    .from = at_m(3, 4),
                    .to = at_m(5, 6),
                    .exit = at_m(7, 8),
                    .approach = {at_m(9, 10), at_m(11, 12)},
                    .approach_altitudes_m = {13, 14},
                    .width = metres(15)};
  return {from(agent, AgentInfo{.agent = AgentId{7}, .boot = BootId{3}, .vehicle = vehicle()}),
          from(agent, AgentState{.agent = AgentId{7},
                                 .boot = BootId{3},
                                 .epoch = Epoch{2},
                                 .revision = 5,
                                 .phase = Phase::offline,
                                 .position = at_m(8, 9),
                                 .heading_rad = 1.5,
                                 .ground_speed = metres_per_second(2.5),
                                 .tank = 0.4,
                                 .battery = 0.6,
                                 .sortie = 1,
                                 .last_grant = 11,
                                 .last_closed = 10}),
          from(scheduler_node(),
               Command{.agent = AgentId{7},
                       .target_boot = BootId{3},
                       .epoch = Epoch{2},
                       .revision = 5,
                       .sorties = {{.pieces = {piece, piece}, .station = StationId{2}},
                                   {.pieces = {piece}, .station = StationId{1}}},
                       .obstacles = {{at_m(13, 14), metres(1.5)}}}),
          from(agent, CommandAck{.agent = AgentId{7},
                                 .boot = BootId{3},
                                 .epoch = Epoch{2},
                                 .revision = 5,
                                 .status = AckStatus::rejected,
                                 .reason = "no"}),
          from(scheduler_node(), WorkGrant{.agent = AgentId{7},
                                           .target_boot = BootId{3},
                                           .epoch = Epoch{2},
                                           .revision = 5,
                                           .closed_through = 9,
                                           .windows = {{10, {1, 2}}, {11, {3, 4}}}}),
          from(agent, WorkReport{.agent = AgentId{7},
                                 .boot = BootId{3},
                                 .epoch = Epoch{2},
                                 .closures = {{.grant = 10,
                                               .cells = {1, 2},
                                               .sprayed = 1,
                                               .reason = CloseReason::tank_low,
                                               .at = Instant{Duration{77}}}}}),
          from(agent, ServiceClaim{.agent = AgentId{7},
                                   .boot = BootId{3},
                                   .station = StationId{2},
                                   .claim = 4,
                                   .first_claimed = Instant{Duration{5}},
                                   .status = ClaimStatus::in_bay,
                                   .token = 6,
                                   .swap = true,
                                   .fill = 0.7}),
          from(station, ServiceGrant{.agent = AgentId{7},
                                     .station = StationId{2},
                                     .claim = 4,
                                     .bay = 1,
                                     .token = 6,
                                     .starts = Instant{Duration{5}},
                                     .ready = Instant{Duration{6}},
                                     .expires = Instant{Duration{7}},
                                     .swap = false,
                                     .fill = 0.25}),
          from(station, StationState{.station = StationId{2},
                                     .bays = {{.bay = 1,
                                               .occupied = true,
                                               .agent = AgentId{7},
                                               .token = 6,
                                               .ready = Instant{Duration{9}}}},
                                     .queue = {AgentId{8}, AgentId{9}},
                                     .swaps = 12,
                                     .filled = litres(34),
                                     .open_bays = 2,
                                     .next_free = Instant{Duration{24}}}),
          from(scheduler_node(), SchedulerState{.epoch = Epoch{2},
                                                .phase = MissionPhase::finished,
                                                .completed = true,
                                                .sprayed_cells = 1,
                                                .open_cells = 2,
                                                .abandoned_cells = 3,
                                                .lost = {AgentId{4}}}),
          from(station, Event{.kind = "agent_lost", .detail = "agent 7 after 3 s"}),
          from(agent, sortie_report()),
          from(agent, FlightRecord{.agent = AgentId{7},
                                   .cells = {5, 2},
                                   .offsets_m = {0.1f, -0.2f},
                                   .truth = {.samples = 1, .sum_squares = 0.5, .largest = 0.25},
                                   .fix = {.samples = 2, .sum_squares = 0.75, .largest = 0.125},
                                   .track = {{.at = Instant{Duration{5}},
                                              .position = at_m(1, 2),
                                              .spraying = true,
                                              .altitude_m = 33,
                                              .width = metres(34)}}}),
          from(agent, ObstacleSeen{.agent = AgentId{7},
                                   .boot = BootId{3},
                                   .epoch = Epoch{2},
                                   .revision = 5,
                                   .obstacle = {at_m(13, 14), metres(1.5)},
                                   .clearance = metres(1.6)}),
          from(scheduler_node(), OperatorState{.epoch = Epoch{2},
                                               .revision = 3,
                                               .level = FleetLevel::land,
                                               .taken_out = {AgentId{4}, AgentId{7}},
                                               .answered = 5,
                                               .refusal = "agent 9 is lost"}),
          from(director_node(),
               OperatorOrder{.ask = OperatorAsk::take_out, .agent = AgentId{7}, .number = 6}),
          from(agent, FlightClaim{.agent = AgentId{7},
                                  .boot = BootId{3},
                                  .claim = 8,
                                  .departure = Departure::in_motion,
                                  .leads_to = {22, 23},
                                  .track = {{Instant{Duration{1}}, at_m(15, 16), 17},
                                            {Instant{Duration{2}}, at_m(18, 19), 20}}}),
          from(scheduler_node(), FlightGrant{.agent = AgentId{7},
                                             .target_boot = BootId{3},
                                             .claim = 8,
                                             .is_clear = true,
                                             .departs = Instant{Duration{21}}})};
}

template <std::size_t topic>
std::string bytes_after_crossing(const Envelope& envelope) {
  auto sample = encoded<topic>(envelope, BootId{9});
  const auto back = decoded<topic>(sample);
  return back ? bytes(*back) : "invalid";
}

TEST_CASE("wire: every message crosses unchanged", "[transport]") {
  const auto all = samples();
  REQUIRE(all.size() == std::variant_size_v<Body>);
  [&]<std::size_t... topic>(std::index_sequence<topic...>) {
    const auto check = [](const Envelope& e, const std::string& crossed) {
      INFO(furrow::topic(e.body));
      CHECK((crossed == bytes(e)));
    };
    (check(all[topic], bytes_after_crossing<topic>(all[topic])), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Body>>{});
}

TEST_CASE("wire: values of an envelope and of a body are those that were sent", "[transport]") {
  // Against a field forgotten in both directions, which the bytes would not show.
  auto sample = encoded<1>(samples()[1], BootId{9});
  const auto back = decoded<1>(sample);
  REQUIRE(back);
  CHECK(back->from == node(AgentId{7}));
  CHECK(back->seq == 42);
  CHECK(back->sent == Instant{Duration{1'234'567'890}});
  const auto& state = std::get<AgentState>(back->body);
  CHECK(state.boot == BootId{3});
  CHECK(state.epoch == Epoch{2});
  CHECK(state.position == at_m(8, 9));
  CHECK(state.last_grant == 11);
  CHECK(state.last_closed == 10);
}

TEST_CASE("wire: the window of an aircraft crosses, and so does that it has none", "[transport]") {
  Envelope info = samples()[0];
  auto sample = encoded<0>(info, BootId{9});
  const auto window = decoded<0>(sample);
  REQUIRE(window);
  CHECK(std::get<AgentInfo>(window->body).vehicle.available_from == seconds(600));
  CHECK(std::get<AgentInfo>(window->body).vehicle.available_until == seconds(700));
  std::get<AgentInfo>(info.body).vehicle.available_until.reset();
  sample = encoded<0>(info, BootId{9});
  const auto endless = decoded<0>(sample);
  REQUIRE(endless);
  CHECK_FALSE(std::get<AgentInfo>(endless->body).vehicle.available_until);
  sample.available_until_s(-1);
  CHECK_FALSE(decoded<0>(sample));
}

TEST_CASE("wire: a value outside the contract invalidates its sample", "[transport]") {
  auto state = encoded<1>(samples()[1], BootId{9});
  state.phase(9);  // 0 .. 8 are phases
  CHECK_FALSE(decoded<1>(state));
  state.phase(8);
  CHECK(decoded<1>(state));
  state.heading_rad(std::numeric_limits<double>::quiet_NaN());
  CHECK_FALSE(decoded<1>(state));
  state.heading_rad(-std::numeric_limits<double>::infinity());
  CHECK_FALSE(decoded<1>(state));

  auto claim = encoded<6>(samples()[6], BootId{9});
  claim.status(0);
  CHECK_FALSE(decoded<6>(claim));
  claim.status(1);
  claim.header().sender_kind(5);
  CHECK_FALSE(decoded<6>(claim));

  auto report = encoded<5>(samples()[5], BootId{9});
  report.closures()[0].reason(200);
  CHECK_FALSE(decoded<5>(report));
}

TEST_CASE("wire: an instant to which no latency can be added invalidates its sample",
          "[transport]") {
  constexpr auto end = std::numeric_limits<std::int64_t>::max();
  auto state = encoded<1>(samples()[1], BootId{9});
  for (const std::int64_t t_ns : {end, end - 1, -end, std::int64_t{1} << 61}) {
    state.header().t_ns(t_ns);
    CHECK_FALSE(decoded<1>(state));
  }
  state.header().t_ns(-5'000'000'000);  // said before a start on the wall clock
  CHECK(decoded<1>(state));

  auto grant = encoded<7>(samples()[7], BootId{9});
  grant.expires_ns(end);
  CHECK_FALSE(decoded<7>(grant));
}

}  // namespace
}  // namespace furrow
