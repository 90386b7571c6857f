#include "planner/fleet/strip_path.hpp"

#include "core/random.hpp"

#include <catch2/catch.hpp>

using namespace furrow;
using namespace furrow::planner::fleet;

namespace {

// Strips to the north, one after another.
StripPath path_of(const std::vector<double>& lengths_m) {
  std::vector<StraightStrip> strips;
  double x = 0;
  for (const double length : lengths_m) {
    strips.push_back({at_m(x, 0), at_m(x, length)});
    x += 4;
  }
  return StripPath{strips};
}

}  // namespace

TEST_CASE("a position at a joint of strips begins on the later and ends on the earlier one") {
  const StripPath path = path_of({10, 5, 20});
  CHECK(path.strip_from(0) == 0);
  CHECK(path.strip_from(10) == 1);
  CHECK(path.strip_to(10) == 0);
  CHECK(path.strip_from(15) == 2);
  CHECK(path.strip_to(15) == 1);
  CHECK(path.strip_to(15.001) == 2);
  CHECK(path.strip_from(35) == 2);
  CHECK(path.strip_to(35) == 2);
  // Outside by rounding.
  CHECK(path.strip_to(-1e-9) == 0);
  CHECK(path.strip_from(35 + 1e-9) == 2);
}

TEST_CASE("positions are found on paths of very uneven strips as by looking at each") {
  Random random{5};
  for (int round = 0; round < 50; ++round) {
    std::vector<double> lengths_m;
    for (std::uint64_t i = 0, n = 1 + random.below(60); i < n; ++i) {
      lengths_m.push_back(random.below(4) == 0 ? random.uniform(1e-6, 1e-3)
                                               : random.uniform(1, 500));
    }
    const StripPath path = path_of(lengths_m);
    const auto check = [&](double at_m) {
      std::uint32_t from = 0, to = 0;
      while (from + 1 < path.strips() && path.begin_m(from + 1) <= at_m) ++from;
      while (to + 1 < path.strips() && path.begin_m(to + 1) < at_m) ++to;
      CHECK(path.strip_from(at_m) == from);
      CHECK(path.strip_to(at_m) == to);
    };
    for (int i = 0; i < 50; ++i) check(random.uniform(0, path.length_m()));
    for (std::uint32_t s = 0; s <= path.strips(); ++s) check(path.begin_m(s));
  }
}
