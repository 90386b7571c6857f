#include "core/random.hpp"
#include "planner/coverage/swath/swath.hpp"
#include "tests/planner/coverage/swath/swath_test_support.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace furrow;
using namespace furrow::planner;

namespace {

// A star-shaped ring around a place, with now and then a repeated vertex, a spike without width,
// or a vertex on a round metre, where rows meet it exactly.
Ring random_ring(Random& random, FieldPoint center, double radius_m, std::uint64_t most_corners) {
  Ring ring;
  const std::uint64_t corners = 3 + random.below(most_corners - 2);
  const bool whole = random.below(3) == 0;
  for (std::uint64_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(i) + 0.8 * random.uniform()) /
                         static_cast<double>(corners);
    const double reach = radius_m * random.uniform(0.25, 1.0);
    double x = center.x.base() + reach * std::cos(angle);
    double y = center.y.base() + reach * std::sin(angle);
    if (whole) x = std::round(x), y = std::round(y);
    ring.push_back(at_m(x, y));
    const std::uint64_t fault = random.below(40);
    if (fault == 0) ring.push_back(ring.back());
    if (fault == 1) {
      ring.push_back(at_m(1.3 * x, 1.3 * y));
      ring.push_back(ring[ring.size() - 2]);
    }
  }
  return ring;
}

Field random_field(Random& random) {
  Field field;
  const double radius_m = random.uniform(15, 90);
  field.boundary = random_ring(random, at_m(0, 0), radius_m, 14);
  const auto place = [&] {
    return at_m(random.uniform(-0.6, 0.6) * radius_m, random.uniform(-0.6, 0.6) * radius_m);
  };
  for (std::uint64_t holes = random.below(3); holes > 0; --holes) {
    field.holes.push_back(random_ring(random, place(), random.uniform(2, 0.4 * radius_m), 7));
  }
  if (random.below(3) == 0)
    field.obstacles.push_back({"tree", place(), metres(random.uniform(1, 6))});
  return field;
}

SwathSettings random_settings(Random& random) {
  SwathSettings s;
  if (random.below(3) == 0) s.margin = metres(random.uniform(0, 4));
  if (random.below(4) == 0) s.hole_buffer = metres(random.uniform(0, 2));
  if (random.below(2) == 0) s.edges = EdgeMode::stay_inside;
  if (random.below(2) == 0) s.last_row = LastRow::narrowed;
  if (random.below(2) == 0) s.direction_deg = random.uniform(0, 360);
  if (random.below(4) == 0) s.min_strip = metres(random.uniform(0, 8));
  if (random.below(5) == 0) s.headland_passes = 1 + static_cast<int>(random.below(2));
  if (random.below(2) == 0) s.near = at_m(-100, 0);
  return s;
}

struct Verdict {
  bool planned = false;
  double outside_m = 0;   // flown
  double unbalanced = 0;  // share by which areas do not add up
  double sprayed_outside_m2 = 0;
  bool inside_only = false;
  bool covers_all = false;
  double covered = 0;
};

Verdict tried(std::uint64_t seed) {
  Random random{seed};
  const Field field = random_field(random);
  SwathSettings settings = random_settings(random);
  const Length swath = metres(random.uniform(1.5, 6));
  if (random.below(2) == 0) settings.row_overlap = random.uniform(0, 0.5) * swath;
  const auto c = swath_coverage(field, swath, settings);
  if (!c) return {};
  const SprayedAreas& a = c->areas;
  const double land_m2 = (a.covered + a.missed).base();
  const double left_m2 = (a.sprayed - a.covered - a.outside - a.repeated).base();
  return {.planned = true,
          .outside_m = outside_m(field, swath, *c),
          .unbalanced = std::abs(left_m2) / land_m2,
          .sprayed_outside_m2 = a.outside.base(),
          .inside_only = settings.edges == EdgeMode::stay_inside && settings.headland_passes == 0,
          .covers_all = settings.edges == EdgeMode::cover_all && settings.margin == Length{} &&
                        settings.hole_buffer == Length{} && settings.min_strip == Length{},
          .covered = covered_share(*c)};
}

void check_seeds(std::uint64_t first, std::uint64_t count) {
  std::uint64_t planned = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const Verdict v = tried(seed);
    if (!v.planned) continue;
    ++planned;
    INFO("seed " << seed);
    CHECK(v.outside_m == 0);
    CHECK(v.unbalanced <= 1e-6);
    if (v.covers_all) CHECK(v.covered >= 0.999);
    if (v.inside_only) CHECK(v.sprayed_outside_m2 <= 1e-3);
  }
  CHECK(planned > count / 2);
}

}  // namespace

TEST_CASE("random fields with holes and faults are covered without leaving them") {
  check_seeds(1, 500);
}

TEST_CASE("random fields that were once left, oversprayed or miscounted stay right") {
  // 50: bends of a headland round were not counted as sprayed; 112: ground between rounds was left
  // out; 726: a turn with the valve open sprayed outside; 5511, 8658: a joined corner left ground
  // out; 6857, 9131: a small part got no strips; 1837, 7853, 8722: small places were left between
  // rounds; 6169: a bay was taken for a cell; 771: an inset was invalid.
  for (const std::uint64_t seed :
       {50, 112, 726, 771, 1837, 5511, 6169, 6857, 7853, 8658, 8722, 9131}) {
    check_seeds(seed, 1);
  }
}

TEST_CASE("ten thousand random fields are covered without leaving them", "[.][long]") {
  check_seeds(1, 10'000);
}
