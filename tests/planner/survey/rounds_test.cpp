#include "planner/survey/rounds.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace furrow::planner {
namespace {

/// Places on a line, visitors at 0 with 1 m/s.
VisitProblem on_a_line(const std::vector<double>& at_m, std::size_t visitors) {
  VisitProblem p{.places = static_cast<std::uint32_t>(at_m.size()),
                 .between_m = {},
                 .back_m = {},
                 .visitors = {}};
  for (const double from_m : at_m) {
    p.back_m.push_back(std::abs(from_m));
    for (const double to_m : at_m) p.between_m.push_back(std::abs(to_m - from_m));
  }
  p.visitors.assign(visitors, {.out_m = p.back_m, .mps = 1.0, .ready_s = 0.0});
  return p;
}

TEST_CASE("rounds: each visitor ends far out, not where the tour comes home") {
  // The tour goes 10, 20, -20, -10. In its direction the second would visit -20 after 20 s and -10
  // after 30 s; the other way round it is done after 20 s, as the first.
  const VisitProblem p = on_a_line({10, 20, -20, -10}, 2);
  CHECK(rounds(p, std::vector<std::uint32_t>{0, 1, 2, 3}) == Rounds{{0, 1}, {3, 2}});
}

TEST_CASE("rounds: places that the tour has apart come into one round") {
  // A tour that goes 10, -10, 20, -20: no cut of it separates the sides.
  const VisitProblem p = on_a_line({10, -10, 20, -20}, 2);
  const Rounds found = rounds(p, std::vector<std::uint32_t>{0, 1, 2, 3});
  REQUIRE(found.size() == 2);
  const bool east_first = found[0] == std::vector<std::uint32_t>{0, 2};
  CHECK(found[east_first ? 0 : 1] == std::vector<std::uint32_t>{0, 2});
  CHECK(found[east_first ? 1 : 0] == std::vector<std::uint32_t>{1, 3});
}

TEST_CASE("rounds: who starts late or flies slowly visits less") {
  VisitProblem p = on_a_line({10, 20, -20, -10}, 2);
  p.visitors[1].ready_s = 1000;
  CHECK(rounds(p, std::vector<std::uint32_t>{0, 1, 2, 3})[1].empty());
}

}  // namespace
}  // namespace furrow::planner
