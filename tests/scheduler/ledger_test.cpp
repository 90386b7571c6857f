#include "scheduler/ledger.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

constexpr AgentId one{1}, two{2};

Closure closure(GrantWindow w, std::uint32_t sprayed, CloseReason reason) {
  return {.grant = w.id, .cells = w.cells, .sprayed = sprayed, .reason = reason, .at = {}};
}

TEST_CASE("ledger: a window closed early leaves its rest open and nothing else", "[scheduler]") {
  Ledger ledger{10};
  const GrantWindow w = ledger.grant(one, {2, 5});
  CHECK(w.id == 1);
  REQUIRE(ledger.book(one, closure(w, 2, CloseReason::tank_low)) == Booking::booked);
  CHECK(ledger.state(3) == CellState::sprayed);
  CHECK(ledger.state(4) == CellState::open);
  CHECK(ledger.counts().sprayed == 2);
  CHECK(ledger.counts().open == 8);
  CHECK(ledger.counts().granted == 0);
  CHECK(ledger.first_open({2, 5}) == CellRange{4, 3});
}

TEST_CASE("ledger: the same closure twice counts once", "[scheduler]") {
  Ledger ledger{4};
  const GrantWindow w = ledger.grant(one, {0, 4});
  CHECK(ledger.book(one, closure(w, 4, CloseReason::sprayed)) == Booking::booked);
  CHECK(ledger.book(one, closure(w, 4, CloseReason::sprayed)) == Booking::known);
  CHECK(ledger.counts().sprayed == 4);
}

TEST_CASE("ledger: refuses what contradicts the books", "[scheduler]") {
  Ledger ledger{10};
  const GrantWindow w = ledger.grant(one, {0, 4});
  CHECK(ledger.book(two, closure(w, 4, CloseReason::sprayed)) == Booking::refused);
  CHECK(ledger.book(one, closure({2, {0, 4}}, 4, CloseReason::sprayed)) == Booking::refused);
  CHECK(ledger.book(one, closure({0, {0, 4}}, 4, CloseReason::sprayed)) == Booking::refused);
  CHECK(ledger.book(one, closure({1, {0, 5}}, 4, CloseReason::tank_low)) == Booking::refused);
  CHECK(ledger.book(one, closure(w, 5, CloseReason::tank_low)) == Booking::refused);
  CHECK(ledger.book(one, closure(w, 3, CloseReason::sprayed)) == Booking::refused);
  CHECK(ledger.counts().granted == 4);
}

TEST_CASE("ledger: closed through rises only over windows closed without a gap", "[scheduler]") {
  Ledger ledger{9};
  const GrantWindow a = ledger.grant(one, {0, 3});
  const GrantWindow b = ledger.grant(one, {3, 3});
  const GrantWindow c = ledger.grant(one, {6, 3});
  CHECK(ledger.closed_through(one) == 0);
  ledger.book(one, closure(c, 3, CloseReason::sprayed));
  ledger.book(one, closure(a, 3, CloseReason::sprayed));
  CHECK(ledger.closed_through(one) == 1);
  CHECK(ledger.last_booked(one) == 3);
  ledger.book(one, closure(b, 3, CloseReason::sprayed));
  CHECK(ledger.closed_through(one) == 3);
  CHECK(ledger.last_granted(one) == 3);
}

TEST_CASE("ledger: what was granted to a lost agent is uncertain, the rest abandoned",
          "[scheduler]") {
  Ledger ledger{12};
  ledger.book(one, closure(ledger.grant(one, {0, 2}), 2, CloseReason::sprayed));
  ledger.grant(one, {2, 3});
  ledger.grant(two, {8, 2});
  CHECK(ledger.forsake(one) == std::vector{CellRange{2, 3}});
  CHECK(ledger.abandon({0, 12}) == std::vector{CellRange{5, 3}, CellRange{10, 2}});
  CHECK(ledger.counts().sprayed == 2);
  CHECK(ledger.counts().uncertain == 3);
  CHECK(ledger.counts().abandoned == 5);
  CHECK(ledger.counts().granted == 2);
  CHECK(ledger.counts().open == 0);
}

}  // namespace
}  // namespace furrow::scheduler
