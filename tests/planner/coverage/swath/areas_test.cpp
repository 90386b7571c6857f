#include "planner/coverage/swath/areas.hpp"

#include "planner/coverage/geos.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace furrow::planner;

namespace {

// Rows of unlike length, 2 m wide and `step_m` apart, turned by 30 degrees.
std::vector<SprayedRun> rows(int count, double step_m) {
  const RowFrame frame{std::sqrt(3.0) / 2, 0.5};
  std::vector<SprayedRun> made;
  for (int i = 0; i < count; ++i) {
    const double v_m = 1 + i * step_m;
    made.push_back({{frame.from({0.3 * (i % 7), v_m}), frame.from({100 - 0.2 * (i % 5), v_m})}, 2});
  }
  return made;
}

LandParts rectangle(double wide_m, double high_m) {
  const RowFrame frame{std::sqrt(3.0) / 2, 0.5};
  LandPart made{{}, {}};
  for (const PointM p : {PointM{0, 0}, {wide_m, 0}, {wide_m, high_m}, {0, high_m}}) {
    made.outer.push_back(frame.from(p));
  }
  return {made};
}

}  // namespace

TEST_CASE("what rows miss is the land less the union of their bands, in stacks as one by one") {
  for (const double step_m : {2.0, 1.9, 1.0}) {  // edge to edge, overlapping, by half
    for (const bool downwards : {false, true}) {
      std::vector<SprayedRun> runs = rows(200, step_m);
      if (downwards) std::reverse(runs.begin(), runs.end());
      const LandParts land = rectangle(100, 199 * step_m + 2);
      LandParts bands;
      for (const SprayedRun& run : runs) bands.push_back(widened(run.path, 1)[0]);
      const double expected_m2 = area_m2(subtracted(land, united(bands)));
      INFO("rows " << step_m << " m apart, " << (downwards ? "down" : "up"));
      CHECK(area_m2(missed_land(runs, land)) == Approx(expected_m2).epsilon(1e-6));
      CHECK(sprayed_areas(runs, land).missed.base() == Approx(expected_m2).epsilon(1e-6));
    }
  }
}
