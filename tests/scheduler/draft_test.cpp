#include "scheduler/draft.hpp"

#include "tests/scheduler/fixture.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

TEST_CASE("recut: an aircraft found to take twice as long gets half as much", "[scheduler]") {
  const planner::Route route = comb(18, 101);
  const std::vector stations{station(1), station(2, 1, at_m(40, 0))};
  const std::vector vehicles{vehicle(1), vehicle(2)};
  const RouteLengths lengths = route_lengths(route, stations);
  // A tank of 2700 m lasts for nine strips: no returns, so times are as good as proportional.
  const std::vector<Share> even{{.strips = {0, 9}, .station = 0, .finish_s = 606},
                                {.strips = {9, 9}, .station = 1, .finish_s = 609}};

  const auto kept = recut(route, lengths, vehicles, stations, even, {606, 609});
  CHECK(kept[0].strips == even[0].strips);

  const auto shares = recut(route, lengths, vehicles, stations, even, {1212, 609});
  CHECK(shares[0].strips == CellRange{0, 6});
  CHECK(shares[1].strips == CellRange{6, 12});
  CHECK(shares[1].station == 1);
}

}  // namespace
}  // namespace furrow::scheduler
