// What nobody has begun goes where stations and time allow.

#include "scheduler/orders.hpp"
#include "tests/scheduler/six_strips.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace furrow::scheduler {
namespace {

using std::chrono::seconds;

/// A scheduler that two agents have accepted the orders of, and what it says by hand.
class Desk {
 public:
  explicit Desk(SchedulerSettings s) : scheduler_{std::move(s)} {
    for (const std::uint32_t id : {1u, 2u}) {
      tell(node(AgentId{id}), at_s(0), AgentInfo{AgentId{id}, BootId{id}, vehicle(id)});
    }
    for (const std::uint32_t id : {1u, 2u}) {
      AgentState state{};
      state.agent = AgentId{id};
      state.boot = BootId{id};
      state.epoch = Epoch{1};
      state.revision = 1;
      state.phase = Phase::spray;
      tell(node(AgentId{id}), at_s(1), state);
    }
    last.clear();
  }

  void tell(NodeId from, Instant now, Body body) {
    step({{from, ++seq_, now, std::move(body)}}, now);
  }
  void step(const Inbox& inbox, Instant now) {
    for (const Body& said : scheduler_.step(inbox, now).messages) {
      if (const auto* c = std::get_if<Command>(&said)) last.insert_or_assign(c->agent, *c);
      if (const auto* e = std::get_if<Event>(&said)) kinds.push_back(e->kind);
    }
  }

  std::map<AgentId, Command> last;  ///< Since the first.
  std::vector<std::string> kinds;   ///< Of events.

 private:
  SchedulerNode scheduler_;
  std::uint64_t seq_ = 0;
};

/// Two aircraft with three sorties each, of which two are granted; the second and third end in the
/// east.
SchedulerSettings to_the_east(const Station& east, const Station& first) {
  SchedulerSettings s = late_joiner();
  s.plan.uavs.pop_back();
  for (UavPlan& uav : s.plan.uavs) {
    uav.station = east;
    uav.landings = {first, east, east};
  }
  return s;
}

/// What was begun stays, the rest goes to station 1, and no cell is lost.
void check_sent_to_station_1(const Desk& desk, StationId east) {
  REQUIRE(desk.last.size() == 2);
  std::size_t cells = 0;
  for (const auto& [agent, command] : desk.last) {
    CHECK(command.revision == 2);
    REQUIRE(command.sorties.size() >= 2);
    CHECK(command.sorties[1].station == east);  // begun: it finds another itself
    for (std::size_t i = 2; i < command.sorties.size(); ++i) {
      CHECK(command.sorties[i].station == StationId{1});
    }
    for (const Piece& piece : pieces(command.sorties)) cells += piece.cells.count;
  }
  CHECK(cells == strips * cells_per_strip);
}

TEST_CASE("reassignment: what nobody has begun goes to stations that are open", "[scheduler]") {
  const Station east = station(2, 1, at_m(12, 0));
  Desk desk{to_the_east(east, station(1))};
  StationState failed{};
  failed.station = east.id;
  for (const std::uint32_t open_bays : {1u, 0u, 0u}) {
    failed.open_bays = open_bays;
    desk.tell(node(east.id), at_s(2), failed);
  }
  check_sent_to_station_1(desk, east.id);
}

TEST_CASE("reassignment: a station that no plan goes to is planned with when another fails",
          "[scheduler]") {
  const Station east = station(2, 1, at_m(12, 0));
  SchedulerSettings s = to_the_east(east, east);
  s.stations = {station(1), east};
  Desk desk{std::move(s)};
  StationState failed{};
  failed.station = east.id;
  desk.tell(node(east.id), at_s(2), failed);
  check_sent_to_station_1(desk, east.id);
}

TEST_CASE("reassignment: who would have to wait behind a long queue is given no more",
          "[scheduler]") {
  const Station east = station(2, 1, at_m(12, 0)), spare = station(3, 1, at_m(6, 0));
  SchedulerSettings s = to_the_east(east, east);
  s.plan.uavs[0].station = station(1);
  s.plan.uavs[0].landings = {};
  s.stations = {station(1), east, spare};
  for (const bool is_long : {false, true}) {
    Desk desk{s};
    StationState queue{};
    queue.station = east.id;
    queue.open_bays = 1;
    queue.next_free = is_long ? at_s(5000) : at_s(2);
    desk.tell(node(east.id), at_s(2), queue);
    StationState failed{};
    failed.station = spare.id;
    desk.tell(node(spare.id), at_s(3), failed);  // what nobody has begun is planned anew
    // Each has begun two of three sorties; the two that are left are shared, or both the first's.
    const auto cells = [&](std::uint32_t agent) {
      std::uint32_t sum = 0;
      for (const Piece& p : pieces(desk.last.at(AgentId{agent}).sorties)) sum += p.cells.count;
      return sum;
    };
    CHECK(cells(1) + cells(2) == strips * cells_per_strip);
    if (is_long) {
      CHECK(cells(2) == 2 * cells_per_strip);
    } else {
      CHECK(cells(2) > 2 * cells_per_strip);
    }
  }
}

TEST_CASE("reassignment: a station that has given away its stock is planned with no more",
          "[scheduler]") {
  Station east = station(2, 1, at_m(12, 0));
  east.mix = litres(30);
  Desk desk{to_the_east(east, station(1))};
  StationState state{};
  state.station = east.id;
  state.open_bays = 1;
  state.filled = litres(29);
  desk.tell(node(east.id), at_s(2), state);
  CHECK(desk.last.empty());
  state.filled = litres(30);
  for (const int t : {3, 4}) desk.tell(node(east.id), at_s(t), state);
  CHECK(std::count(desk.kinds.begin(), desk.kinds.end(), "stock_empty") == 1);
  check_sent_to_station_1(desk, east.id);
}

TEST_CASE("reassignment: who joins after a long pause is given its share all the same",
          "[scheduler]") {
  // The others are forecast to be done at 100 s and were held from 2 s to 1000 s: at 1098 s.
  // Without the pause they would seem to be done as fast as their 30 cells can be sprayed, 20 s
  // from now.
  SchedulerSettings s = late_joiner();
  s.agent_lease = seconds{5000};
  s.mission_limit = seconds{10'000};
  s.orders = {{at_s(2), {OperatorAsk::pause}}, {at_s(1000), {OperatorAsk::resume}}};
  Desk desk{std::move(s)};
  for (int t = 2; t <= 1000; t += 2) desk.step({}, at_s(t));
  desk.tell(node(AgentId{3}), at_s(1001), AgentInfo{AgentId{3}, BootId{3}, vehicle(3)});
  CHECK(std::count(desk.kinds.begin(), desk.kinds.end(), "work_taken_over") == 1);
  CHECK(desk.last.at(AgentId{3}).sorties.size() == 1);
}

TEST_CASE("reassignment: work that a station closes before goes to one that is open",
          "[scheduler]") {
  Station east = station(2, 1, at_m(12, 0));
  east.available_until = furrow::seconds(3.0);
  Desk desk{to_the_east(east, station(1))};
  desk.step({}, at_s(2));
  CHECK(desk.last.empty());
  for (const int t : {3, 4}) desk.step({}, at_s(t));
  CHECK(std::count(desk.kinds.begin(), desk.kinds.end(), "station_closed") == 1);
  check_sent_to_station_1(desk, east.id);
}

}  // namespace
}  // namespace furrow::scheduler
