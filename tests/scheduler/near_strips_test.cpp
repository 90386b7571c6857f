#include "scheduler/near_strips.hpp"

#include <catch2/catch.hpp>

namespace furrow::scheduler {
namespace {

planner::Strip strip(FieldPoint from, FieldPoint to) {
  return planner::end_strip({0, 1}, from, to, {});
}

TEST_CASE("near strips: rows a swath apart are not near, a last row shifted onto them is",
          "[scheduler]") {
  // 4 m apart, the last one 0.7 m from the one before.
  const auto route = planner::end_to_end_route(
      metres(4), {strip(at_m(2, 0), at_m(2, 50)), strip(at_m(6, 50), at_m(6, 0)),
                  strip(at_m(10, 0), at_m(10, 50)), strip(at_m(10.7, 50), at_m(10.7, 0))});
  CHECK(strips_near_others(route, metres(1.8)) == std::vector<bool>{false, false, true, true});
  CHECK(strips_near_others(route, metres(0.6)) == std::vector<bool>(4, false));
}

TEST_CASE("near strips: rows that end at a round along the edge are near to it", "[scheduler]") {
  // The round lies along x at y = 2. The first row ends 1.5 m before it, the second 3 m.
  const auto route = planner::end_to_end_route(
      metres(4), {strip(at_m(2, 3.5), at_m(2, 50)), strip(at_m(6, 50), at_m(6, 5)),
                  strip(at_m(0, 2), at_m(60, 2))});
  CHECK(strips_near_others(route, metres(2)) == std::vector<bool>{true, false, true});
}

TEST_CASE("near strips: parts of one row are near to each other", "[scheduler]") {
  const auto route = planner::end_to_end_route(
      metres(4), {strip(at_m(0, 0), at_m(30, 40)), strip(at_m(30, 40), at_m(60, 80))});
  CHECK(strips_near_others(route, metres(1)) == std::vector<bool>{true, true});
}

}  // namespace
}  // namespace furrow::scheduler
