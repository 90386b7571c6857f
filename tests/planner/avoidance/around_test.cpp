#include "planner/avoidance/around.hpp"

#include "planner/coverage/cover.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow;
using namespace furrow::planner;

namespace {

Field orchard() {
  Field field{{at_m(0, 0), at_m(60, 0), at_m(60, 120), at_m(0, 120)}, {}, {}};
  field.obstacles = {{"a", at_m(15.5, 60), metres(1)},
                     {"b", at_m(33, 40), metres(1.5)},
                     {"c", at_m(45, 80), metres(0.5)},
                     {"end", at_m(27, 117), metres(1)}};
  return field;
}

SwathSettings settings_around() {
  SwathSettings s;
  s.direction_deg = 0;
  s.avoidance.emplace();
  s.avoidance->safety = metres(1.5);
  s.avoidance->turn_radius = metres(3);
  return s;
}

double nearest_m(const std::vector<FieldPoint>& line, FieldPoint p) {
  PathM path;
  for (const FieldPoint at : line) path.push_back({at.x.base(), at.y.base()});
  return distance_m({p.x.base(), p.y.base()}, path);
}

}  // namespace

TEST_CASE("rows run on past trees: every strip and every way between keeps clear") {
  const Field field = orchard();
  std::optional<AvoidanceRecord> record;
  const auto made = coverage_around(field, metres(6), settings_around(), record);
  REQUIRE(made);
  REQUIRE(record);
  CHECK(record->planned.targets >= 4);
  CHECK(record->planned.blocked >= 1);  // at the end of its row
  CHECK(record->unjoined == 0);
  for (const Obstacle& o : field.obstacles) {
    for (const SwathStrip& strip : made->strips) {
      CHECK(nearest_m({strip.from, strip.to}, o.center) >= o.radius.base() + 1.5 - 1e-5);
      if (strip.approach.empty()) continue;
      CHECK(nearest_m(strip.approach, o.center) >= o.radius.base() + 1.5 - 1e-5);
    }
  }
}

TEST_CASE(
    "rows run on past outlines and end at those told to end them, all at the safety distance") {
  Field field{{at_m(0, 0), at_m(120, 0), at_m(120, 120), at_m(0, 120)}, {}, {}};
  // A shed of 3 x 2 m on a row and a barn of 30 x 30 m, held by circles of 1.8 and 21 m.
  field.obstacles = {outlined("shed", {at_m(14, 50), at_m(17, 50), at_m(17, 52), at_m(14, 52)}),
                     outlined("barn", {at_m(60, 40), at_m(90, 40), at_m(90, 70), at_m(60, 70)})};
  SwathSettings settings = settings_around();
  settings.avoidance->ends_rows = {1};
  std::optional<AvoidanceRecord> record;
  const auto made = coverage_around(field, metres(6), settings, record);
  REQUIRE(made);
  CHECK(record->planned.targets == 1);
  CHECK(record->planned.detours + record->planned.closed == 1);
  CHECK(record->unjoined == 0);
  for (const SwathStrip& strip : made->strips) {
    std::vector<FieldPoint> way = strip.approach;
    way.insert(way.end(), {strip.from, strip.to});
    for (std::size_t i = 1; i < way.size(); ++i) {
      const FieldVector leg = way[i] - way[i - 1];
      for (int k = 0; k <= 200; ++k) {
        const FieldPoint at = way[i - 1] + FieldVector{0.005 * k * leg.x, 0.005 * k * leg.y};
        for (const Obstacle& o : field.obstacles) CHECK(-depth_in(o, at).base() > 1.5 - 1e-5);
      }
    }
  }
}

TEST_CASE("strips and ways of a detour follow one another without a gap") {
  std::optional<AvoidanceRecord> record;
  const auto made = coverage_around(orchard(), metres(6), settings_around(), record);
  REQUIRE(made);
  for (std::size_t i = 1; i < made->strips.size(); ++i) {
    const SwathStrip& strip = made->strips[i];
    REQUIRE(strip.approach.size() >= 2);
    CHECK(distance(made->strips[i - 1].to, strip.approach.front()).base() < 1e-5);
    CHECK(distance(strip.approach.back(), strip.from).base() < 1e-5);
  }
}

TEST_CASE("the record tells what half circles would have missed and repeated") {
  Field field = orchard();
  field.obstacles.pop_back();  // a half circle at the end of a row would leave the field
  const auto around = cover(field, metres(6), settings_around());
  REQUIRE(around);
  REQUIRE(around->sweep->avoidance);
  const AvoidanceRecord& record = *around->sweep->avoidance;
  CHECK(record.safety == metres(1.5));
  CHECK(record.planned.missed + record.planned.repeated <
        record.classic.missed + record.classic.repeated);
  SwathSettings ending = settings_around();
  ending.avoidance.reset();
  CHECK_FALSE(cover(field, metres(6), ending)->sweep->avoidance);
}

TEST_CASE("what rows overlap by on purpose is not what detours repeat") {
  SwathSettings overlapping = settings_around();
  overlapping.row_overlap = metres(1);
  const auto around = cover(orchard(), metres(6), overlapping);
  REQUIRE(around);
  const double straight_m = around->sweep->sprayed.base();
  CHECK(around->sweep->areas.repeated.base() > 0.5 * 1 * straight_m);
  CHECK(around->sweep->avoidance->planned.repeated.base() < 0.1 * 1 * straight_m);
}

TEST_CASE("aircraft with a turn radius join strips by turns inside the field or say otherwise") {
  SwathSettings settings = settings_around();
  settings.avoidance->dubins_turns = true;
  settings.margin = metres(3);
  std::optional<AvoidanceRecord> record;
  const auto made = coverage_around(orchard(), metres(6), settings, record);
  REQUIRE(made);
  CHECK(record->turns + record->unturned >= 8);  // nine rows or more
}

TEST_CASE("a field that obstacles leave no strip of is refused") {
  Field alley{{at_m(0, 0), at_m(6, 0), at_m(6, 14), at_m(0, 14)}, {}, {}};
  alley.obstacles = {{"block", at_m(3, 7), metres(2.5)}};
  SwathSettings settings = settings_around();
  settings.avoidance->safety = metres(5);
  std::optional<AvoidanceRecord> record;
  const auto none = coverage_around(alley, metres(6), settings, record);
  REQUIRE_FALSE(none);
  CHECK(none.error().fault == PlanFault::nothing_to_spray);
}

TEST_CASE("an outlined obstacle ends rows while trees are flown around") {
  Field field = orchard();
  field.obstacles.push_back(
      outlined("pond", {at_m(38, 90), at_m(52, 90), at_m(52, 100), at_m(38, 100)}));
  std::optional<AvoidanceRecord> record;
  const auto made = coverage_around(field, metres(6), settings_around(), record);
  REQUIRE(made);
  for (const SwathStrip& strip : made->strips) {
    const FieldPoint middle =
        at_m((strip.from.x + strip.to.x).base() / 2, (strip.from.y + strip.to.y).base() / 2);
    CHECK(depth_in(field.obstacles.back(), middle) <= metres(1e-6));
  }
  CHECK(record->planned.detours >= 3);
}

TEST_CASE("an obstacle across an alley is refused with the place") {
  Field alley{{at_m(0, 0), at_m(6, 0), at_m(6, 60), at_m(0, 60)}, {}, {}};
  alley.obstacles = {{"block", at_m(3, 30), metres(2.5)}};
  std::optional<AvoidanceRecord> record;
  const auto none = coverage_around(alley, metres(6), settings_around(), record);
  REQUIRE_FALSE(none);
  CHECK(none.error().detail.find("obstacles cut the field: no way leads from (3.0, ") == 0);
}
