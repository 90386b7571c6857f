#include "planner/avoidance/turns.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace furrow;
using namespace furrow::planner;

namespace {

const LandParts square{{{{0, 0}, {60, 0}, {60, 60}, {0, 60}}, {}}};

PathM plane(const std::vector<FieldPoint>& line) {
  PathM path;
  for (const FieldPoint p : line) path.push_back({p.x.base(), p.y.base()});
  return path;
}

}  // namespace

TEST_CASE("a turn well inside the field is the shortest Dubins path") {
  const auto turn = strip_turn({at_m(20, 40), M_PI / 2}, {at_m(30, 40), -M_PI / 2}, metres(5),
                               Room{{}, {}, square});
  REQUIRE(turn);
  CHECK(turn->is_inside);
  CHECK(turn->length.base() == Approx(5 * M_PI));
}

TEST_CASE("a turn that would swing outside is flown inside where a way is found") {
  // Strips 4 m apart that end 6 m before the edge: the omega of R = 3 reaches sqrt(36 - 25) + 3 =
  // 6.3 m beyond them.
  const Room room{{}, {}, square};
  const auto turn =
      strip_turn({at_m(20, 54), M_PI / 2}, {at_m(24, 54), -M_PI / 2}, metres(3), room);
  REQUIRE(turn);
  CHECK(turn->is_inside);
  CHECK(room.is_inside(plane(turn->way)));
}

TEST_CASE("a turn at the very edge leaves the field and says so") {
  const auto turn = strip_turn({at_m(20, 60), M_PI / 2}, {at_m(30, 60), -M_PI / 2}, metres(5),
                               Room{{}, {}, square});
  REQUIRE(turn);
  CHECK_FALSE(turn->is_inside);
}

TEST_CASE("a turn keeps clear of an obstacle beside the strips' ends") {
  const Room room{{{{25, 46}, 3}}, {}, square};
  const auto turn =
      strip_turn({at_m(20, 40), M_PI / 2}, {at_m(30, 40), -M_PI / 2}, metres(5), room);
  REQUIRE(turn);
  CHECK(room.is_free(plane(turn->way)));
  CHECK(turn->length.base() > 5 * M_PI);
}
