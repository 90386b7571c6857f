#include "scheduler/scheduler_node.hpp"
#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <utility>

namespace furrow::scheduler {
namespace {

using std::chrono::seconds;

constexpr Instant at_s(int s) { return Instant{seconds{s}}; }

// Six strips of ten cells, three for each of two aircraft.
SchedulerSettings ordered(std::vector<TimedOrder> orders) {
  FleetPlan p{.route = comb(6, 10),
              .work_direction_deg = 0,
              .uavs = {},
              .makespan_s = 0,
              .lower_bound_s = 0};
  p.uavs = {uav_plan(p.route, 1, {0, 3}, {}), uav_plan(p.route, 2, {3, 3}, {})};
  return {.plan = p,
          .epoch = Epoch{1},
          .agent_lease = seconds{100},
          .mission_limit = seconds{600},
          .orders = std::move(orders)};
}

/// A scheduler whose two agents have accepted their orders and hold two windows each.
class Desk {
 public:
  explicit Desk(std::vector<TimedOrder> orders) : scheduler_{ordered(std::move(orders))} {
    for (const std::uint32_t i : {1u, 2u}) {
      step(0, {AgentInfo{AgentId{i}, BootId{i}, vehicle(i)}});
    }
    for (const std::uint32_t i : {1u, 2u}) {
      step(1, {CommandAck{AgentId{i}, BootId{i}, Epoch{1}, 1, AckStatus::accepted, {}}});
    }
  }

  std::vector<Body> step(int s, const std::vector<Body>& told = {}) {
    Inbox inbox;
    for (const Body& body : told) inbox.push_back({node(AgentId{1}), ++seq_, at_s(s), body});
    std::vector<Body> said = scheduler_.step(inbox, at_s(s)).messages;
    said_.insert(said_.end(), said.begin(), said.end());
    return said;
  }

  std::vector<Body> hear_phase(int s, std::uint32_t agent, Phase phase) {
    AgentState state{};
    state.agent = AgentId{agent};
    state.boot = BootId{agent};
    state.epoch = Epoch{1};
    state.revision = 1;
    state.phase = phase;
    return step(s, {state});
  }

  /// The agent gives both of its windows back with `sprayed` cells of the first.
  std::vector<Body> close_both(int s, std::uint32_t agent, std::uint32_t sprayed) {
    const std::uint32_t first = agent == 1 ? 0 : 30;
    return step(s, {WorkReport{AgentId{agent},
                               BootId{agent},
                               Epoch{1},
                               {{1, {first, 10}, sprayed, CloseReason::recalled, at_s(s)},
                                {2, {first + 10, 10}, 0, CloseReason::recalled, at_s(s)}}}});
  }

  std::size_t events(std::string_view kind) const {
    std::size_t count = 0;
    for (const Body& body : said_) {
      const auto* event = std::get_if<Event>(&body);
      count += event != nullptr && event->kind == kind;
    }
    return count;
  }
  const Ledger& ledger() const { return scheduler_.ledger(); }

 private:
  SchedulerNode scheduler_;
  std::uint64_t seq_ = 0;
  std::vector<Body> said_;
};

template <class M>
std::vector<M> all(const std::vector<Body>& said) {
  std::vector<M> found;
  for (const Body& body : said) {
    if (const auto* m = std::get_if<M>(&body)) found.push_back(*m);
  }
  return found;
}

TEST_CASE("operator: an order is a level, said at once and with every heartbeat from then on",
          "[scheduler]") {
  Desk desk{{{at_s(3), {OperatorAsk::pause}}, {at_s(9), {OperatorAsk::resume}}}};
  CHECK(all<OperatorState>(desk.step(2)).empty());
  const auto now = all<OperatorState>(desk.step(3));
  REQUIRE(now.size() == 1);
  CHECK(now[0].level == FleetLevel::hold);
  CHECK(now[0].revision == 1);
  for (const int s : {4, 6, 8}) CHECK(all<OperatorState>(desk.step(s)).size() == 1);
  CHECK(all<OperatorState>(desk.step(7)).empty());
  const auto then = all<OperatorState>(desk.step(9));
  REQUIRE(then.size() == 1);
  CHECK(then[0].level == FleetLevel::fly);
  CHECK(then[0].revision == 2);
}

TEST_CASE("operator: the same order twice is one, and wakes the scheduler when it is due",
          "[scheduler]") {
  SchedulerNode scheduler{
      ordered({{at_s(1), {OperatorAsk::pause}}, {at_s(2), {OperatorAsk::pause}}})};
  CHECK(scheduler.step({}, at_s(0)).wake == at_s(1));
  CHECK(all<OperatorState>(scheduler.step({}, at_s(1)).messages)[0].revision == 1);
  CHECK(all<OperatorState>(scheduler.step({}, at_s(2)).messages)[0].revision == 1);
}

TEST_CASE("operator: who is taken out is granted nothing more and leaves its work to the others",
          "[scheduler]") {
  Desk desk{{{at_s(3), {OperatorAsk::take_out, AgentId{1}}}}};
  const auto told = desk.step(3);
  CHECK(all<OperatorState>(told)[0].taken_out == std::vector{AgentId{1}});
  CHECK(desk.events("work_taken_over") == 0);  // its windows are still open
  const auto after = desk.close_both(5, 1, 4);
  CHECK(desk.events("work_taken_over") == 1);
  for (const WorkGrant& grant : all<WorkGrant>(after)) {
    if (grant.agent == AgentId{1}) CHECK(grant.windows.empty());
  }
  const auto commands = all<Command>(after);
  REQUIRE(commands.size() == 1);
  CHECK(commands[0].agent == AgentId{2});
  std::uint32_t cells = 0;
  for (const auto& sortie : commands[0].sorties) {
    for (const Piece& piece : sortie.pieces) cells += piece.cells.count;
  }
  CHECK(cells == 30 + 26);  // its own, and what the other has not sprayed of its 30
  desk.hear_phase(6, 1, Phase::offline);
  CHECK(desk.events("agent_lost") == 0);
}

TEST_CASE("operator: a stopped mission gives up the rest and ends when all are down",
          "[scheduler]") {
  Desk desk{{{at_s(3), {OperatorAsk::stop}}}};
  desk.hear_phase(2, 2, Phase::spray);
  desk.step(3);
  // Two windows of ten cells each are in the hands of both; the other 20 are nobody's.
  CHECK(desk.ledger().counts().abandoned == 20);
  CHECK(desk.ledger().counts().granted == 40);
  desk.close_both(5, 1, 7);
  desk.hear_phase(6, 1, Phase::offline);
  desk.close_both(7, 2, 10);
  CHECK(desk.events("mission_finished") == 0);  // the second is still in the air
  const auto last = all<SchedulerState>(desk.hear_phase(8, 2, Phase::offline));
  REQUIRE_FALSE(last.empty());
  CHECK(last.back().phase == MissionPhase::finished);
  CHECK_FALSE(last.back().completed);
  CHECK(last.back().sprayed_cells == 17);
  CHECK(last.back().abandoned_cells == 43);
  CHECK(desk.events("agent_lost") == 0);
}

TEST_CASE("operator: orders for the lost, for strangers and after a stop are refused",
          "[scheduler]") {
  Desk desk{{{at_s(3), {OperatorAsk::take_out, AgentId{9}}},
             {at_s(103), {OperatorAsk::take_out, AgentId{2}}},
             {at_s(104), {OperatorAsk::stop}},
             {at_s(105), {OperatorAsk::resume}}}};
  desk.step(3);
  CHECK(desk.events("order_refused") == 1);
  desk.hear_phase(50, 1, Phase::spray);
  desk.step(102);  // the second has been silent for more than its lease of 100 s
  REQUIRE(desk.events("agent_lost") == 1);
  desk.step(103);
  CHECK(desk.events("order_refused") == 2);
  desk.step(104);
  CHECK(all<OperatorState>(desk.step(106)).back().level == FleetLevel::end);
  CHECK(desk.events("order_refused") == 3);
}

TEST_CASE("operator: an order that is said until it is answered is obeyed once", "[scheduler]") {
  Desk desk{{}};
  const auto first =
      all<OperatorState>(desk.step(3, {OperatorOrder{.ask = OperatorAsk::pause, .number = 1}}));
  REQUIRE(first.size() == 1);
  CHECK(first[0].answered == 1);
  CHECK(first[0].refusal.empty());
  desk.step(4, {OperatorOrder{.ask = OperatorAsk::resume, .number = 2}});
  desk.step(5, {OperatorOrder{.ask = OperatorAsk::pause, .number = 1}});  // late
  const auto second = all<OperatorState>(desk.step(6));
  CHECK(second.back().level == FleetLevel::fly);
  CHECK(second.back().answered == 2);
  const OperatorOrder stranger{.ask = OperatorAsk::take_out, .agent = AgentId{9}, .number = 3};
  const auto third = all<OperatorState>(desk.step(7, {stranger}));
  REQUIRE(third.size() == 1);
  CHECK(third[0].answered == 3);
  CHECK(third[0].refusal == "agent 9 is not of this mission");
  CHECK(third[0].revision == second.back().revision);
}

}  // namespace
}  // namespace furrow::scheduler
