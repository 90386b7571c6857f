#include "agents/conduct/order.hpp"

#include "tests/agents/scripted_fleet.hpp"

#include <catch2/catch.hpp>

namespace furrow::agents {
namespace {

Piece piece(CellRange cells) {
  const double y_m = 2.0 * cells.count - 1.0;
  return {.cells = cells,
          .entry = at_m(1, 1),
          .from = at_m(1, 1),
          .to = at_m(1, y_m),
          .exit = at_m(1, y_m)};
}

// Cells 10 to 14 on the first sortie, 0 to 4 on the second.
Command backwards() {
  return {AgentId{1},
          BootId{1},
          Epoch{1},
          1,
          {{{piece({10, 5})}, StationId{1}}, {{piece({0, 5})}, StationId{1}}}};
}

TEST_CASE("order: cells come in the order of its pieces, whatever their numbers", "[agents]") {
  Order order{backwards()};
  CHECK(order.next_cell() == 10);
  CHECK(order.is_open({0, 5}));
  CHECK(order.is_open({12, 3}));
  CHECK_FALSE(order.is_open({4, 2}));
  for (int i = 0; i < 5; ++i) CHECK(order.spray() == (i == 4));
  CHECK(order.next_cell() == 0);
  CHECK_FALSE(order.is_open({10, 5}));
  CHECK_FALSE((order.spray(), order.is_open({0, 5})));
  CHECK(order.is_open({1, 4}));
}

TEST_CASE("order: a cell ordered twice is refused", "[agents]") {
  const std::vector<Station> stations{depot()};
  Command command = backwards();
  CHECK_FALSE(fault_in(command, stations));
  command.sorties[1].pieces[0] = piece({6, 5});
  CHECK(fault_in(command, stations) == "cell 10 is ordered twice");
}

TEST_CASE("order: begins behind what is sprayed, which comes first or is refused", "[agents]") {
  const Order order{backwards(), {10, 11, 12, 13, 14, 0}};
  CHECK(order.sortie() == 1);
  CHECK(order.next_cell() == 1);
  CHECK(Order{backwards(), {10, 11, 12, 13, 14, 0, 1, 2, 3, 4}}.is_finished());
  CHECK(fault_in(backwards(), {}, {}) == "station 1 is unknown");
  const std::vector<Station> stations{depot()};
  CHECK_FALSE(fault_in(backwards(), stations, {10, 11}));
  CHECK(fault_in(backwards(), stations, {10, 12}) == "cell 12 is sprayed already");
}

TEST_CASE("order: goes on as another with the same rest of the sortie", "[agents]") {
  Command longer = backwards();
  longer.sorties.push_back({{piece({20, 5})}, StationId{1}});
  CHECK(Order{backwards(), {10, 11}}.goes_on_as(Order{longer, {10, 11}}));
  CHECK_FALSE(Order{backwards(), {10, 11}}.goes_on_as(Order{longer, {10}}));
  longer.sorties[0].station = StationId{2};
  CHECK_FALSE(Order{backwards(), {10, 11}}.goes_on_as(Order{longer, {10, 11}}));
}

}  // namespace
}  // namespace furrow::agents
