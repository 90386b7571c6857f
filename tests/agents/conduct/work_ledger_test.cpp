#include "agents/conduct/work_ledger.hpp"

#include "tests/agents/scripted_fleet.hpp"

#include <catch2/catch.hpp>

namespace furrow::agents {
namespace {

const Order order{Command{agent_7, boot_1, Epoch{3}, 2, {{strips(3, 10), StationId{1}}}}};

WorkGrant level(std::vector<GrantWindow> windows, std::uint64_t closed_through = 0) {
  return {agent_7, boot_1, Epoch{3}, 2, closed_through, std::move(windows)};
}

TEST_CASE("work ledger: takes each window once, however often it is told", "[agents]") {
  WorkLedger ledger;
  CHECK(ledger.accept(level({{1, {0, 10}}, {2, {10, 10}}}), order));
  CHECK_FALSE(ledger.accept(level({{1, {0, 10}}, {2, {10, 10}}}), order));
  CHECK_FALSE(ledger.accept(level({{1, {0, 10}}}), order));
  CHECK(ledger.last_accepted() == 2);
  CHECK(ledger.licensed_to(0) == 20);
  CHECK(ledger.licensed_to(25) == 25);
}

TEST_CASE("work ledger: refuses another epoch, another revision and cells across pieces",
          "[agents]") {
  WorkLedger ledger;
  WorkGrant old = level({{1, {0, 10}}});
  old.epoch = Epoch{2};
  CHECK_FALSE(ledger.accept(old, order));
  WorkGrant other = level({{1, {0, 10}}});
  other.revision = 1;
  CHECK_FALSE(ledger.accept(other, order));
  CHECK_FALSE(ledger.accept(level({{1, {5, 10}}}), order));
  CHECK_FALSE(ledger.accept(level({{1, {30, 1}}}), order));
  CHECK(ledger.last_accepted() == 0);
}

TEST_CASE("work ledger: fits an order that holds what is left of its windows", "[agents]") {
  WorkLedger ledger;
  ledger.accept(level({{1, {0, 10}}}), order);
  for (std::uint32_t cell = 0; cell < 4; ++cell) ledger.spray(cell, Instant{});
  const std::vector<SortieOrder> without_first{{{strips(3, 10)[1]}, StationId{1}}};
  CHECK(ledger.sprayed_cells() == std::set<std::uint32_t>{0, 1, 2, 3});
  CHECK(ledger.fits(order));
  CHECK_FALSE(ledger.fits(Order{Command{agent_7, boot_1, Epoch{3}, 3, without_first}}));
}

TEST_CASE("work ledger: closes in part and takes up the rest under a new id", "[agents]") {
  WorkLedger ledger;
  ledger.accept(level({{1, {0, 10}}, {2, {10, 10}}}), order);
  Order work = order;
  for (std::uint32_t cell = 0; cell < 4; ++cell) {
    CHECK_FALSE(ledger.spray(cell, Instant{}));
    work.spray();
  }
  ledger.close_all(CloseReason::tank_low, Instant{});
  REQUIRE(ledger.closures().size() == 2);
  CHECK(ledger.closures()[0].sprayed == 4);
  CHECK(ledger.closures()[1].sprayed == 0);
  CHECK(ledger.licensed_to(4) == 4);

  CHECK_FALSE(ledger.accept(level({{3, {0, 10}}}), work));  // some of it is sprayed
  CHECK(ledger.accept(level({{3, {4, 6}}}, 1), work));
  CHECK(ledger.closures().size() == 1);  // the first is on the books
  CHECK(ledger.licensed_to(4) == 10);
}

TEST_CASE("work ledger: windows join whatever the order of their ids", "[agents]") {
  WorkLedger ledger;
  ledger.accept(level({{1, {10, 10}}, {2, {0, 4}}, {3, {4, 6}}}), order);
  CHECK(ledger.licensed_to(0) == 20);
}

}  // namespace
}  // namespace furrow::agents
